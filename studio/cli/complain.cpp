#include "studio/cli/complain.hpp"

#include <fmt/core.h>

#include "studio/cli/exit_code.hpp"

namespace wale {

int complain(std::string_view about, std::string_view message, std::string_view hint) {
  fmt::print(stderr, "{}: error: {}\n", about, message);
  if (!hint.empty()) fmt::print(stderr, "  hint: {}\n", hint);
  return bad_input;
}

}  // namespace wale
