/// Where a fabric would be balanced if its yarns pushed each other otherwise: a start for where no equilibrium is
/// found.
#pragma once

#include <optional>

#include "sim/scene.hpp"

namespace wale {

/// The same scene by another contact law: the barrier in place of the other two, which yield where yarns come near or
/// suddenly stop them; in its place one of a tenth of its stiffness. Nothing if the stage has no contact.
std::optional<Scene> by_another_law(const Scene&, const Stage&);

}  // namespace wale
