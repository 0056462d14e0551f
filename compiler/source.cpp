#include "compiler/source.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace wale {

LineColumn locate(const Span& span) {
  if (!span.source) return {};
  const std::string_view text = span.source->text;
  const std::string_view before = text.substr(0, std::min<std::size_t>(span.begin, text.size()));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
  const auto lines = std::count(before.begin(), before.end(), '\n');
  return {static_cast<int>(lines) + 1, static_cast<int>(before.size() - line_start) + 1};
}

LineColumn Locator::operator()(const Span& span) {
  if (!span.source) return {};
  const auto [known, is_new] = line_ends_.try_emplace(span.source);
  std::vector<std::uint32_t>& ends = known->second;
  const std::string& text = span.source->text;
  for (std::size_t at = is_new ? text.find('\n') : text.npos; at != text.npos; at = text.find('\n', at + 1))
    ends.push_back(static_cast<std::uint32_t>(at));
  const auto end = std::lower_bound(ends.begin(), ends.end(), span.begin);
  const std::uint32_t line_start = end == ends.begin() ? 0 : *(end - 1) + 1;
  return {static_cast<int>(end - ends.begin()) + 1, static_cast<int>(span.begin - line_start) + 1};
}

const Source* Sources::add(std::string name, std::string text) {
  texts_.push_back({std::move(name), std::move(text)});
  return &texts_.back();
}

const Source* Sources::read(const std::string& path) {
  for (const Source& known : texts_) {
    if (known.name == path) return &known;
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return nullptr;
  std::ifstream file(path, std::ios::binary);
  if (!file) return nullptr;
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad() || text.size() >= std::numeric_limits<std::uint32_t>::max()) return nullptr;
  return add(path, std::move(text));
}

}  // namespace wale
