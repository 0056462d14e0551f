/// Files that are whole or not there: written beside their target, then renamed.
#pragma once

#include <string>
#include <string_view>

namespace wale {

/// Where a file is written before it takes its name.
inline std::string part_of(const std::string& path) { return path + ".part"; }

/// Opens part_of(path) for writing, empty, to see that it can be done. Throws std::system_error with the path.
void open_part(const std::string& path);
/// Gives the finished part its name, in place of any older file. Throws std::system_error with the path.
void rename_part(const std::string& path);
/// Removes what an unsuccessful write left.
void drop_part(const std::string& path) noexcept;

/// Writes all bytes to `path`, or throws std::system_error with the path and leaves what was there.
void write_file(const std::string& path, std::string_view bytes);
/// Throws std::system_error with the path unless it is a file that can be read.
void check_readable(const std::string& path);
/// All bytes of a file. Throws std::system_error with the path.
std::string read_file(const std::string& path);

}  // namespace wale
