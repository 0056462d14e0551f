/// Rows of symbols in a YAML block: the part of a chart that is drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/yaml.hpp"

namespace wale {

struct PictureCell {
  std::string symbol;  ///< as in the legend, or the symbol of a yarn
  int part = 0;        ///< which cell of a symbol that is several cells wide
  Span span;
};

/// rows[0] is the first course, which is the last line of the text; all rows are equally wide.
struct Picture {
  std::vector<std::vector<PictureCell>> rows;
  Span span;
  int wales() const { return rows.empty() ? 0 : static_cast<int>(rows.front().size()); }
  int courses() const { return static_cast<int>(rows.size()); }
};

/// A block drawn with `|`, as opposed to a name.
bool is_picture(const YamlNode&);

/// Splits a block into symbols, the longest known symbol first, and checks that the rows are equally wide.
/// Blanks between symbols do not count, `#` begins a comment, ` x3` at the end of a line repeats it.
/// `kind` names the picture in messages ("stitch"). Reports every fault it finds.
std::optional<Picture> read_picture(const YamlNode&, std::string_view kind, const std::vector<std::string>& symbols,
                                    Diagnostics&);

}  // namespace wale
