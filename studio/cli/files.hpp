/// Writing files so that a reader never sees half of one.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace wale {

/// Lets `write` make a file beside `path`, with the same suffix, and renames it to `path`. What was there stays if
/// anything is thrown. Throws std::system_error with the path.
void replace_file(const std::filesystem::path& path, const std::function<void(const std::string& beside)>& write);

/// The same for a text.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// Makes the folder if need be, and makes sure that files can be made in it. Throws std::system_error with the path.
void prepare_folder(const std::filesystem::path&);

/// Tells on stderr that a file or folder cannot be written, and why.
void complain_unwritable(const std::string& path, const std::exception&);

}  // namespace wale
