/// The folder that a run leaves behind.
#pragma once

#include <filesystem>

#include "sim/results/results.hpp"

namespace wale {

inline constexpr const char* results_name = "results.h5";

/// Makes the folder if need be, and makes sure that files can be made in it. Throws std::system_error with the path.
void prepare_folder(const std::filesystem::path&);

/// curve.csv and summary.json, and then results.h5, which holds the phases up to here.
void write_tables(const Results&, const std::filesystem::path& folder);

/// frames.pvd with frames/*.vtp, fabric_relaxed.svg, fabric_pulled.svg, curve.svg.
void write_pictures(const Results&, const std::filesystem::path& folder);

}  // namespace wale
