/// Texts that a user wrote, and places in them.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wale {

struct Source {
  std::string name;  ///< as the user would type it: a path
  std::string text;
};

/// Bytes [begin, end) of a source; line and column are found when printed.
struct Span {
  const Source* source = nullptr;
  std::uint32_t begin = 0, end = 0;
};

struct LineColumn {
  int line = 0, column = 0;  ///< from 1; columns count bytes
};
/// Zeros for a span without a source.
LineColumn locate(const Span&);

/// locate() of many spans: finds the line ends of a source once, where that counts from the beginning each time.
class Locator {
 public:
  LineColumn operator()(const Span&);

 private:
  std::map<const Source*, std::vector<std::uint32_t>> line_ends_;
};

/// Keeps every text of a run alive, so that spans stay good, and so that results can hold what made them.
class Sources {
 public:
  const Source* add(std::string name, std::string text);
  /// Reads a file, or gives what was added under that name before. Null if it cannot be read.
  const Source* read(const std::string& path);
  const std::deque<Source>& all() const { return texts_; }

 private:
  std::deque<Source> texts_;
};

}  // namespace wale
