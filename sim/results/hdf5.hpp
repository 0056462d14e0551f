/// Results as one HDF5 file that gives back every bit, and the compiled fabric alone. The layout is in docs/results.md.
///
/// Files are written beside their target and renamed, so an interrupted write never harms an older file.
/// An unwritable or unreadable place throws std::system_error, a file with other or damaged content
/// std::runtime_error; both name the path. Not for concurrent use, as HDF5 itself is not.
#pragma once

#include <string>

#include "sim/results/results.hpp"

namespace wale {

/// Everything but Scene::stages, which the texts in the manifest hold. All snapshots must have as many control points
/// as the first of them (std::invalid_argument).
void write_hdf5(const Results&, const std::string& path);

/// What write_hdf5() wrote, bit for bit; Scene::stages is empty: compile them again from Manifest::sources.
Results read_hdf5(const std::string& path);

/// The fabric as compiled: control points, materials, and the stitch of every segment with its place in the source.
void write_fabric_hdf5(const Fabric&, const std::string& path);

}  // namespace wale
