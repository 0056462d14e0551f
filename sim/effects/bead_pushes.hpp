/// Carries the pushes of touching beads to the control points.
#pragma once

#include <functional>
#include <vector>

#include "sim/effects/beads.hpp"

namespace wale {

/// Appends the contacts whose segment a is `first` ... `last` - 1, ascending in a.
using ListContacts = std::function<void(int first, int last, std::vector<BeadContact>&)>;

/// Adds the energy and the forces of all contacts between beads that the materials' contact laws give. `list` is called
/// by several threads, once for each range of Beads::boundaries(). `q` are the columns of State::q.
void add_pushes(const Beads&, const Points& q, const ListContacts& list, Load& out);

}  // namespace wale
