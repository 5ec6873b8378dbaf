// Ctrl-C as a stop token, so that nothing is left half written.
#pragma once

#include <stop_token>

namespace isocast {

/// The token that the first Ctrl-C (or SIGTERM) triggers; the first call installs the handlers. A second
/// signal ends the process at once.
std::stop_token interrupt_token();

/// Throws Interrupted when Ctrl-C was pressed.
void throw_if_interrupted();

}  // namespace isocast
