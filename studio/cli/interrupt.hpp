/// Ctrl-C as a flag that a run looks at.
#pragma once

#include <atomic>

namespace wale {

/// From now on SIGINT and SIGTERM set the flag that is given back; a second one ends the process as usual.
const std::atomic<bool>& catch_interrupts();

}  // namespace wale
