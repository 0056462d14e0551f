/// The commands of `wale`. Each adds itself to the command line, and sets the exit code when it has run.
#pragma once

#include <CLI/CLI.hpp>

namespace wale {

void add_check(CLI::App&, int& exit_code);
void add_compile(CLI::App&, int& exit_code);
void add_run(CLI::App&, int& exit_code);
void add_curve(CLI::App&, int& exit_code);
void add_patterns(CLI::App&, int& exit_code);
void add_accuracy(CLI::App&, int& exit_code);
void add_explain(CLI::App&, int& exit_code);

}  // namespace wale
