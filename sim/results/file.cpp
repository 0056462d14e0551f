#include "sim/results/file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace wale {
namespace {

[[noreturn]] void fail(const char* what, const std::string& path) {
  const int error = errno != 0 ? errno : EIO;
  throw std::system_error(error, std::generic_category(), std::string(what) + " " + path);
}

}  // namespace

void open_part(const std::string& path) {
  errno = 0;
  if (!std::ofstream(part_of(path), std::ios::binary | std::ios::trunc)) fail("cannot write", path);
}

void rename_part(const std::string& path) {
  std::error_code error;
  std::filesystem::rename(part_of(path), path, error);
  if (!error) return;
  drop_part(path);
  throw std::system_error(error, "cannot write " + path);
}

void drop_part(const std::string& path) noexcept {
  std::error_code ignored;
  std::filesystem::remove(part_of(path), ignored);
}

void write_file(const std::string& path, std::string_view bytes) {
  errno = 0;
  std::ofstream out(part_of(path), std::ios::binary | std::ios::trunc);
  if (!out) fail("cannot write", path);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    const int error = errno;
    drop_part(path);
    errno = error;
    fail("cannot write", path);
  }
  rename_part(path);
}

void check_readable(const std::string& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  in.peek();  // a folder opens, but cannot be read
  if (!in.is_open() || in.bad()) fail("cannot read", path);
}

std::string read_file(const std::string& path) {
  check_readable(path);
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace wale
