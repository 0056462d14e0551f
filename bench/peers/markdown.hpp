/// A table as Markdown shows it, printed row by row as they come.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

namespace wale::peers {

using Row = std::vector<std::string>;

inline void print_row(const Row& cells) {
  fmt::print("| {} |\n", fmt::join(cells, " | "));
  std::fflush(stdout);
}

inline void print_heading(const Row& cells) {
  print_row(cells);
  print_row(Row(cells.size(), "---"));
}

}  // namespace wale::peers
