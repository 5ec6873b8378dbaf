// Formulas solved by an engine.
#pragma once

#include <isocast/cuda/queue_pool.h>

namespace isocast {

/// `pool` serves all solvers.
[[nodiscard]] std::shared_ptr<const FormulaDevice> make_formula_device(std::shared_ptr<const QueuePool> pool);

}  // namespace isocast
