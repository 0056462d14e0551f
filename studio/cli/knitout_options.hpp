/// What a command line may ask of a knitout file: a part of it, how long its loops are, which yarn lies in front.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "compiler/compile.hpp"

namespace wale {

/// As typed; empty where nothing was.
struct KnitoutWords {
  std::string courses, needles, stitch_length, plating;
};

/// Adds `--plating`, which means the same to every command.
void add_plating(CLI::App& command, KnitoutWords&);

/// Nothing, and what is wrong on stderr, if the words make no sense. `sources` keeps them for messages.
std::optional<KnitoutOptions> read_knitout_options(const KnitoutWords&, Sources& sources);

}  // namespace wale
