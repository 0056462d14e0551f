/// What a user's file is, and reading it.
#pragma once

#include <string>

#include "compiler/source.hpp"

namespace wale {

enum class FileKind { chart, scene, knitout };

/// As holds_knitout() says, or by the keys at the left margin: only a scene has `scene:` and `stages:`.
FileKind kind_of(const Source&);
std::string_view name_of(FileKind);

/// Then says on stderr that it is none where a scene was wanted.
bool is_knitout(const Source&);

/// Null, and one line on stderr, if the file cannot be read.
const Source* read_or_complain(Sources&, const std::string& path);

}  // namespace wale
