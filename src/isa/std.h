// The few standard types that kernels may use.
#pragma once

#include <cstddef>
#include <cstdint>
