#include "studio/cli/complain.hpp"

#include <fmt/core.h>

#include "studio/cli/exit_code.hpp"

namespace wale {

int complain(std::string_view about, std::string_view message, std::string_view hint) {
  fmt::print(stderr, "{}: error: {}\n", about, message);
  if (!hint.empty()) fmt::print(stderr, "  hint: {}\n", hint);
  return bad_input;
}

int complain_unwritable(std::string_view path, const std::system_error& error) {
  return complain(path, "cannot be written: " + error.code().message(), "give a place that you may write to with -o");
}

}  // namespace wale
