#include "studio/cli/input.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>

namespace wale {
namespace {

bool has_key(const std::string& text, std::string_view key) {
  const std::string line = std::string(key) + ":";
  return text.starts_with(line) || text.find("\n" + line) != std::string::npos;
}

}  // namespace

FileKind kind_of(const Source& source) {
  if (source.name.ends_with(".k") || source.text.starts_with(";!knitout")) return FileKind::knitout;
  return has_key(source.text, "stages") || has_key(source.text, "fabric") ? FileKind::scene : FileKind::chart;
}

std::string_view name_of(FileKind kind) {
  switch (kind) {
    case FileKind::scene: return "scene";
    case FileKind::knitout: return "knitout";
    case FileKind::chart: break;
  }
  return "chart";
}

const Source* read_or_complain(Sources& sources, const std::string& path) {
  errno = 0;
  const Source* source = sources.read(path);
  if (!source) {
    const char* reason = errno ? std::strerror(errno) : "it is not a text file";
    fmt::print(stderr, "{}: error: cannot be read: {}\n", path, reason);
  }
  return source;
}

}  // namespace wale
