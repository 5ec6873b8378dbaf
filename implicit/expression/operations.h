// The operations of formulas on one number, beside those of real.h: the same bits on every instruction set.
#pragma once

#include <isocast/math/elementary.h>
#include <isocast/math/functions.h>
