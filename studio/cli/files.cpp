#include "studio/cli/files.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace wale {
namespace {

namespace fs = std::filesystem;

void write_text(const std::string& path, std::string_view text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) throw std::system_error(errno ? errno : EIO, std::generic_category(), path);
}

fs::path beside(const fs::path& path) {
  fs::path name = path.stem();
  name += fmt::format(".partial-{}", ::getpid());
  name += path.extension();
  return path.parent_path() / name;
}

}  // namespace

void replace_file(const fs::path& path, const std::function<void(const std::string&)>& write) {
  const fs::path partial = beside(path);
  try {
    write(partial.string());
    fs::rename(partial, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw;
  }
}

void replace_file(const fs::path& path, std::string_view text) {
  replace_file(path, [&](const std::string& partial) { write_text(partial, text); });
}

void prepare_folder(const fs::path& folder) {
  fs::create_directories(folder);
  const fs::path probe = beside(folder / "probe");
  write_text(probe.string(), "");
  fs::remove(probe);
}

void complain_unwritable(const std::string& path, const std::exception& error) {
  const auto* failure = dynamic_cast<const std::system_error*>(&error);
  fmt::print(stderr, "{}: error: cannot be written: {}\n  hint: give another place with -o\n", path,
             failure ? failure->code().message() : error.what());
}

}  // namespace wale
