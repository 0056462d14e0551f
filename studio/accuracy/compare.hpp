/// Errors and orders of a study's trials, once they have run.
#pragma once

#include "studio/accuracy/study.hpp"

namespace wale {

/// Fills in `error`, `own_error`, `rests_elsewhere`, the orders and the reference. The last ladder is `together`; the
/// finest of it that ran is the reference.
void compare(Study&);

}  // namespace wale
