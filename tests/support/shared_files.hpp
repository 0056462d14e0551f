/// Reference files beside the checkout, which a test skips without.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace wale {

inline const std::filesystem::path shared_folder = WALE_SHARED_DIR;

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace wale
