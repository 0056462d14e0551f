#include "compiler/front/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "compiler/front/limits.hpp"
#include "compiler/spelling.hpp"

namespace wale {
namespace {

using Row = std::vector<PictureCell>;

/// One line of a picture: where its symbols stand, and how often it is knitted.
struct Line {
  Span span;
  int repeats = 1;
};

std::string_view text_of(const Span& span) {
  return std::string_view(span.source->text).substr(span.begin, span.end - span.begin);
}

Span trimmed(Span span) {
  const auto blank = [&](std::uint32_t at) { return std::isspace(static_cast<unsigned char>(span.source->text[at])); };
  while (span.begin < span.end && blank(span.begin)) ++span.begin;
  while (span.begin < span.end && blank(span.end - 1)) --span.end;
  return span;
}

/// Bytes of the UTF-8 character that begins here.
std::size_t character_length(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0u) == 0x80u) ++length;
  return length;
}

class PictureReader {
 public:
  PictureReader(std::string_view kind, std::vector<std::string> symbols, Diagnostics& say)
      : kind_(kind), symbols_(std::move(symbols)), say_(say) {
    std::stable_sort(symbols_.begin(), symbols_.end(),
                     [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  }

  std::optional<Picture> read(const YamlNode& node) {
    Picture picture;
    picture.span = node.span;
    for (const Span& written : lines_of(node)) add_line(written, picture);
    if (good_ && picture.rows.empty())
      fail("C009", node.span, "this picture holds no rows", "draw one row of symbols a line");
    if (!good_) return std::nullopt;
    std::reverse(picture.rows.begin(), picture.rows.end());
    return picture;
  }

 private:
  void fail(std::string_view code, Span span, std::string message, std::string hint) {
    say_.error(code, span, std::move(message), std::move(hint));
    good_ = false;
  }

  /// The source lines of a block; a plain one-line scalar is its own line.
  static std::vector<Span> lines_of(const YamlNode& node) {
    std::vector<Span> lines;
    Span rest = node.span;
    const std::string& text = rest.source->text;
    if (node.style == YamlNode::Style::literal) {
      rest.begin = static_cast<std::uint32_t>(std::min<std::size_t>(text.find('\n', rest.begin), rest.end));
    } else if (node.style == YamlNode::Style::quoted) {
      ++rest.begin;
      --rest.end;
    }
    while (rest.begin < rest.end) {
      const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(text.find('\n', rest.begin), rest.end));
      lines.push_back({rest.source, rest.begin, end});
      rest.begin = end + 1;
    }
    return lines;
  }

  void add_line(Span written, Picture& picture) {
    written.end =
        written.begin + static_cast<std::uint32_t>(std::min(text_of(written).find('#'), text_of(written).size()));
    written = trimmed(written);
    if (written.begin == written.end) return;
    const Line line = split_repeat(written);
    const Row row = split_symbols(line.span);
    if (row.empty()) return;
    if (!picture.rows.empty() && static_cast<int>(row.size()) != picture.wales()) {
      fail("C004", line.span, fmt::format("this row is {} wales wide, the row above {}", row.size(), picture.wales()),
           "make all rows of a picture equally wide");
      return;
    }
    const long courses = picture.courses() + line.repeats;
    if (courses > limits::most_courses || courses * static_cast<long>(row.size()) > limits::most_cells) {
      fail("C012", line.span, fmt::format("a picture of {} courses is too high here", courses), "repeat less often");
      return;
    }
    picture.rows.insert(picture.rows.end(), static_cast<std::size_t>(line.repeats), row);
  }

  /// Takes a repeat mark such as ` x3` off the end of a line.
  Line split_repeat(const Span& written) {
    const std::string_view text = text_of(written);
    const std::size_t blank = text.find_last_of(" \t");
    if (blank == std::string_view::npos || blank + 2 >= text.size() || text[blank + 1] != 'x') return {written};
    const std::string_view digits = text.substr(blank + 2);
    if (!std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c); })) return {written};
    Line line{trimmed({written.source, written.begin, written.begin + static_cast<std::uint32_t>(blank)})};
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), line.repeats);
    if (result.ec != std::errc{} || line.repeats < 1 || line.repeats > limits::most_courses) {
      fail("C012", {written.source, written.end - static_cast<std::uint32_t>(digits.size()) - 1, written.end},
           fmt::format("a row cannot be repeated {} times", digits),
           fmt::format("repeat it 1 to {} times", limits::most_courses));
      line.repeats = 1;
    }
    return line;
  }

  /// Empty after a fault.
  Row split_symbols(const Span& line) {
    Row row;
    const std::string_view text = text_of(line);
    for (std::size_t at = 0; at < text.size();) {
      const std::string_view rest = text.substr(at);
      if (std::isspace(static_cast<unsigned char>(rest[0]))) {
        ++at;
        continue;
      }
      const auto found = std::find_if(symbols_.begin(), symbols_.end(),
                                      [&](const std::string& symbol) { return rest.starts_with(symbol); });
      const std::size_t length = found != symbols_.end() ? found->size() : character_length(rest);
      const auto begin = line.begin + static_cast<std::uint32_t>(at);
      if (found == symbols_.end()) {
        report_unknown({line.source, begin, begin + static_cast<std::uint32_t>(length)});
        return {};
      }
      add_symbol(*found, begin, line.source, row);
      at += length;
    }
    if (static_cast<int>(row.size()) > limits::most_wales) {
      fail("C012", line, fmt::format("this row is over {} wales wide", limits::most_wales), "draw fewer stitches");
      return {};
    }
    return row;
  }

  /// A symbol is as many cells wide as it has characters.
  static void add_symbol(const std::string& symbol, std::uint32_t begin, const Source* source, Row& row) {
    std::uint32_t at = 0;
    for (int part = 0; at < symbol.size(); ++part) {
      const auto length = static_cast<std::uint32_t>(character_length(std::string_view(symbol).substr(at)));
      row.push_back({symbol, part, {source, begin + at, begin + at + length}});
      at += length;
    }
  }

  void report_unknown(const Span& span) {
    std::vector<std::string_view> known(symbols_.begin(), symbols_.end());
    std::sort(known.begin(), known.end());
    fail("C003", span, fmt::format("unknown {} symbol \"{}\"", kind_, text_of(span)), suggest(text_of(span), known));
  }

  std::string_view kind_;
  std::vector<std::string> symbols_;
  Diagnostics& say_;
  bool good_ = true;
};

}  // namespace

bool is_picture(const YamlNode& node) {
  if (node.kind != YamlNode::Kind::scalar) return false;
  return node.style == YamlNode::Style::literal || node.style == YamlNode::Style::folded ||
         node.text.find('\n') != std::string::npos;
}

std::optional<Picture> read_picture(const YamlNode& node, std::string_view kind,
                                    const std::vector<std::string>& symbols, Diagnostics& say) {
  const bool one_line = node.kind == YamlNode::Kind::scalar && node.style != YamlNode::Style::folded &&
                        node.text.find('\n') == std::string::npos;
  if (!one_line && node.style != YamlNode::Style::literal) {
    say.error("C009", node.span, "a picture must be a block of text behind `|`",
              "write `|` behind the colon, and one row a line below it, indented");
    return std::nullopt;
  }
  return PictureReader(kind, symbols, say).read(node);
}

}  // namespace wale
