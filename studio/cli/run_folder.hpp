/// The folder that a run leaves behind.
#pragma once

#include <filesystem>

#include "sim/results/results.hpp"

namespace wale {

inline constexpr const char* results_name = "results.h5";

/// Makes the folder if need be, and makes sure that files can be made in it. Everything here throws std::system_error
/// with the path if it cannot.
void prepare_folder(const std::filesystem::path&);

/// results.h5 as it is so far.
void write_snapshots(const Results&, const std::filesystem::path& folder);

/// curve.csv, summary.json and results.h5.
void write_tables(const Results&, const std::filesystem::path& folder);

/// frames.pvd with frames/*.vtp, fabric_relaxed.svg, fabric_pulled.svg, fabric_curl.svg, curve.svg.
void write_pictures(const Results&, const std::filesystem::path& folder);

}  // namespace wale
