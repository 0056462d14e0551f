#include "compiler/yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace wale {
namespace {

constexpr int most_nodes = 200'000;  // an alias can name a list of aliases: a short text, an endless tree

std::uint32_t offset(std::size_t position) { return static_cast<std::uint32_t>(position); }

/// Turns yaml-cpp's nodes, which know where they start, into ours, which know where they end too.
class TreeBuilder {
 public:
  TreeBuilder(const Source& source, std::size_t mark_offset, Diagnostics& say)
      : source_(source), text_(source.text), mark_offset_(mark_offset), say_(say) {}

  YamlNode build(const YAML::Node& from, Span without_value) {
    YamlNode node;
    if (++nodes_ > most_nodes) return node;
    node.span = {&source_, start(from.Mark()), start(from.Mark())};
    switch (from.Type()) {
      case YAML::NodeType::Undefined:
      case YAML::NodeType::Null:
        node.span = without_value;
        break;
      case YAML::NodeType::Scalar:
        read_scalar(from, node);
        break;
      case YAML::NodeType::Sequence:
        read_list(from, node);
        break;
      case YAML::NodeType::Map:
        read_map(from, node);
        break;
    }
    return node;
  }
  bool too_big() const { return nodes_ > most_nodes; }

 private:
  std::uint32_t start(const YAML::Mark& mark) const {
    const std::size_t position = mark.is_null() ? 0 : static_cast<std::size_t>(mark.pos) + mark_offset_;
    return offset(std::min(position, text_.size()));
  }

  void read_scalar(const YAML::Node& from, YamlNode& node) {
    node.kind = YamlNode::Kind::scalar;
    node.text = from.Scalar();
    const std::size_t begin = skip_properties(node.span.begin);
    node.span.begin = offset(begin);
    const char first = begin < text_.size() ? text_[begin] : '\0';
    if (first == '|' || first == '>') {
      node.style = first == '|' ? YamlNode::Style::literal : YamlNode::Style::folded;
      node.span.end = offset(end_of_block(begin));
    } else if (first == '"' || first == '\'') {
      node.style = YamlNode::Style::quoted;
      node.span.end = offset(end_of_quotes(begin));
    } else {
      const bool on_one_line = text_.compare(begin, node.text.size(), node.text) == 0;
      node.span.end = offset(on_one_line ? begin + node.text.size() : std::min(text_.find('\n', begin), text_.size()));
    }
  }

  /// Behind `&anchor` and `!tag`, which yaml-cpp counts as part of the node.
  std::size_t skip_properties(std::size_t at) const {
    while (at < text_.size() && (text_[at] == '&' || text_[at] == '!')) {
      at = std::min(text_.find_first_of(" \n", at), text_.size());
      at = std::min(text_.find_first_not_of(" \n", at), text_.size());
    }
    return at;
  }

  std::size_t end_of_quotes(std::size_t begin) const {
    const char quote = text_[begin];
    for (std::size_t i = begin + 1; i < text_.size(); ++i) {
      if (quote == '"' && text_[i] == '\\') {
        ++i;
      } else if (quote == '\'' && text_.compare(i, 2, "''") == 0) {
        ++i;
      } else if (text_[i] == quote) {
        return i + 1;
      }
    }
    return text_.size();
  }

  /// The column of the key or the dash that a block belongs to.
  std::size_t column_outside(std::size_t block) const {
    const std::size_t line = block == 0 ? 0 : text_.rfind('\n', block - 1) + 1;
    std::size_t column = 0, at = text_.find_first_not_of(' ', line);
    while (at < block) {
      column = at - line;
      if (text_[at] != '-') break;
      at = text_.find_first_not_of(' ', at + 1);
    }
    return column;
  }

  /// A block ends before the first line that is indented no deeper than what it belongs to.
  std::size_t end_of_block(std::size_t begin) const {
    const std::size_t outside = column_outside(begin);
    std::size_t end = std::min(text_.find('\n', begin), text_.size());
    for (std::size_t line = end; line < text_.size();) {
      const std::size_t first = text_.find_first_not_of(" \r", line + 1);
      if (first == std::string::npos) break;
      const bool blank = text_[first] == '\n';
      if (!blank && first - line - 1 <= outside) break;
      line = std::min(text_.find('\n', first), text_.size());
      if (!blank) end = line;
    }
    return end;
  }

  void read_list(const YAML::Node& from, YamlNode& node) {
    node.kind = YamlNode::Kind::list;
    for (const auto& item : from) node.items.push_back(build(item, node.span));
    if (!node.items.empty()) node.span.end = std::max(node.span.end, node.items.back().span.end);
    include_bracket(node, ']');
  }

  void read_map(const YAML::Node& from, YamlNode& node) {
    node.kind = YamlNode::Kind::map;
    for (const auto& pair : from) {
      const YamlNode key = build(pair.first, node.span);
      if (key.kind != YamlNode::Kind::scalar) {
        say_.error("Y004", key.span, "a key must be a word", "put the word in quotes if it holds special characters");
        continue;
      }
      node.span.end = std::max(node.span.end, key.span.end);
      if (node.find(key.text)) {
        say_.error("Y006", key.span, fmt::format("the key \"{}\" is given twice", key.text), "remove one of the two");
        continue;
      }
      node.entries.push_back({key.text, key.span, build(pair.second, key.span)});
      node.span.end = std::max(node.span.end, node.entries.back().value.span.end);
    }
    include_bracket(node, '}');
  }

  void include_bracket(YamlNode& node, char bracket) const {
    const std::size_t begin = skip_properties(node.span.begin);
    if (begin >= text_.size() || text_[begin] != (bracket == ']' ? '[' : '{')) return;
    const std::size_t closing = text_.find(bracket, node.span.end);
    if (closing != std::string::npos) node.span.end = offset(closing + 1);
  }

  const Source& source_;
  const std::string& text_;
  const std::size_t mark_offset_;
  Diagnostics& say_;
  int nodes_ = 0;
};

/// YAML does not allow tabs as indentation, and parsers word it in puzzling ways.
bool report_tab(const Source& source, Diagnostics& say) {
  const std::string& text = source.text;
  for (std::size_t line = 0; line < text.size();) {
    const std::size_t first = std::min(text.find_first_not_of(" \t\r", line), text.size());
    const std::size_t tab = text.find('\t', line);
    const bool blank = first == text.size() || text[first] == '\n' || text[first] == '#';
    if (tab < first && !blank) {
      say.error("Y002", {&source, offset(tab), offset(tab + 1)}, "a tab indents this line",
                "indent with spaces: YAML does not allow tabs here");
      return true;
    }
    const std::size_t end = text.find('\n', line);
    if (end == std::string::npos) break;
    line = end + 1;
  }
  return false;
}

/// Remembers where the latest document began.
class DocumentStarts final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { latest = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

  YAML::Mark latest;
};

/// YAML::LoadAll would never end on a stray comma, which it takes for one empty document after another.
std::optional<YAML::Mark> second_document(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStarts documents;
  if (!parser.HandleNextDocument(documents) || !parser.HandleNextDocument(documents)) return std::nullopt;
  return documents.latest;
}

std::string plain_words(const std::string& complaint) {
  std::string message = complaint;
  if (!message.empty()) message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  while (!message.empty() && message.back() == '.') message.pop_back();
  return "this is not YAML: " + message;
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  for (const YamlEntry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

std::optional<YamlNode> parse_yaml(const Source& source, Diagnostics& say) {
  if (report_tab(source, say)) return std::nullopt;
  const std::size_t byte_order_mark = source.text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  const auto place = [&](const YAML::Mark& mark) -> Span {
    const std::size_t at = mark.is_null() ? 0 : static_cast<std::size_t>(mark.pos) + byte_order_mark;
    const auto begin = offset(std::min(at, source.text.size()));
    return {&source, begin, begin};
  };
  const Span start{&source, 0, 0};
  try {
    const YAML::Node document = YAML::Load(source.text);
    if (const auto more = second_document(source.text)) {
      say.error("Y001", place(*more), "a second document begins here, or something that is not YAML",
                "keep one chart or scene a file, and remove stray commas and brackets");
      return std::nullopt;
    }
    if (!document || document.IsNull()) {
      say.error("Y001", start, "the file holds nothing", "begin a chart with `knit: 1`, a scene with `scene: 1`");
      return std::nullopt;
    }
    TreeBuilder builder(source, byte_order_mark, say);
    YamlNode root = builder.build(document, start);
    if (!builder.too_big()) return root;
    say.error("Y001", start, "the file holds too many values", "write out fewer of its aliases");
  } catch (const YAML::Exception& problem) {
    const bool open_bracket = problem.msg.find("flow") != std::string::npos;
    say.error("Y001", place(problem.mark), plain_words(problem.msg),
              open_bracket ? "close the bracket above; a # behind a blank begins a comment, so put colours in quotes"
                           : "check indentation, colons, brackets and quotes here and in the line above");
  }
  return std::nullopt;
}

}  // namespace wale
