/// Errors that have no place in a text: a file that is not there, a command line that makes no sense.
#pragma once

#include <string_view>
#include <system_error>

namespace wale {

/// Prints `about: error: message` and the hint on stderr. Gives the exit code for bad input.
int complain(std::string_view about, std::string_view message, std::string_view hint = {});

/// The same for a file or folder that was asked for with -o.
int complain_unwritable(std::string_view path, const std::system_error&);

}  // namespace wale
