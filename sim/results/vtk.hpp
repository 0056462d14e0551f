/// Yarns for ParaView and other readers of VTK: `.vtp` for one state, `.pvd` for a run.
///
/// The XML is written by hand, with the numbers appended as raw bytes: two element types are all that is used of
/// it, while the VTK library is larger than this program and its dependencies together.
#pragma once

#include <string>

#include "sim/rest_length.hpp"
#include "sim/results/results.hpp"

namespace wale {

enum class YarnShape : std::uint8_t {
  tubes,  ///< surfaces of the yarns' true diameter, which show at once
  lines   ///< centre lines; `radius` feeds a Tube filter
};

struct VtkOptions {
  YarnShape shape = YarnShape::tubes;
  int per_segment = 3;  ///< rings or points a segment, from 1
  int sides = 8;        ///< of a tube, from 3
  RestLengths rest{0};  ///< for the strain
};

/// A PolyData file. Point data: `stretch_energy` (per rest length, J/m; the active array), `strain`, `curvature`
/// (1/m), `radius` (m, lines only), `material`, `stitch`; cell data: `yarn`. Lengths in m.
std::string vtp(const Fabric&, const Points& q, const VtkOptions& options = {});

/// vtp() as a file. Throws std::system_error with the path.
void write_vtp(const Fabric&, const Points& q, const std::string& path, const VtkOptions& options = {});

/// `folder`/frames.pvd, and a file in `folder`/frames for every snapshot but those at the start of a later stage,
/// which are the end of the one before; see shown_fabric(). Time runs on from stage to stage, s. The rest lengths are
/// those of each snapshot; `options.rest` is not used. Throws std::system_error with the path.
void write_frames(const Results&, const std::string& folder, const VtkOptions& options = {});

}  // namespace wale
