// The two macros of the project: where a function runs, and which build of it this is.
#pragma once

#if defined(__CUDACC__)
#define ISO_HD __host__ __device__
#else
#define ISO_HD
#endif

// Kernels are compiled once per instruction set in a namespace of that name, so that no two builds share a
// symbol.
#ifndef ISO_ISA
#define ISO_ISA base
#endif
