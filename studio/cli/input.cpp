#include "studio/cli/input.hpp"

#include <cerrno>
#include <cstring>

#include "compiler/compile.hpp"
#include "studio/cli/complain.hpp"

namespace wale {
namespace {

bool has_key(const std::string& text, std::string_view key) {
  const std::string line = std::string(key) + ":";
  return text.starts_with(line) || text.find("\n" + line) != std::string::npos;
}

}  // namespace

FileKind kind_of(const Source& source) {
  if (holds_knitout(source)) return FileKind::knitout;
  const bool scene = has_key(source.text, "scene") || has_key(source.text, "stages");
  return scene ? FileKind::scene : FileKind::chart;
}

std::string_view name_of(FileKind kind) {
  switch (kind) {
    case FileKind::scene:
      return "scene";
    case FileKind::knitout:
      return "knitout";
    case FileKind::chart:
      break;
  }
  return "chart";
}

const Source* read_or_complain(Sources& sources, const std::string& path) {
  errno = 0;
  const Source* source = sources.read(path);
  if (!source)
    complain(path, std::string("cannot be read: ") + (errno ? std::strerror(errno) : "it is not a text file"));
  return source;
}

bool is_knitout(const Source& source) {
  if (kind_of(source) != FileKind::knitout) return false;
  complain(source.name + ":1:1", "a scene was wanted, and this is a knitout file", "`wale check` reads it");
  return true;
}

}  // namespace wale
