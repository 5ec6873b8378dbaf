// The macros of the project: where a function runs, and which build of it this is.
#pragma once

// ISO_HD_CALLED: of what is large and rare, which a GPU's code calls and does not repeat.
#if defined(__CUDACC__)
#define ISO_HD __host__ __device__
#define ISO_HD_CALLED __host__ __device__ __noinline__
#else
#define ISO_HD
#define ISO_HD_CALLED
#endif

// Kernels are compiled once per instruction set in a namespace of that name, so that no two builds share a
// symbol.
#ifndef ISO_ISA
#define ISO_ISA base
#endif
