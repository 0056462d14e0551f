/// The peers' patch by our solvers: its size at rest, what it costs, and whether finer yarn changes it.
#pragma once

namespace wale::peers {

/// At rest, after the ramp to 95 %, as Markdown tables: with more and more segments a stitch, with smaller and smaller
/// tolerances, and with a rest curvature that has no side.
void study_patch(int wales, int courses);

/// By CVODE as the peers moved it: ramped within 0.02 s under their drag, after 0.12 s.
void move_patch(int wales, int courses);

}  // namespace wale::peers
