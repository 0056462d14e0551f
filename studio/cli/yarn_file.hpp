/// The files that `wale compile` writes, by suffix.
#pragma once

#include <string>

#include "compiler/compile.hpp"

namespace wale {

/// Or says on stderr why not.
bool can_write_yarns(const std::string& path);

/// Writes the fabric as laid: .h5 exactly, with the place in the source of each stitch; .vtp, .obj and .bcc as
/// curves; .svg as a picture. `path` must pass can_write_yarns(). Throws std::system_error with the path.
void write_yarns(const Compiled&, const std::string& path);

}  // namespace wale
