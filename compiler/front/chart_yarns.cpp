#include <fmt/format.h>

#include "compiler/fields.hpp"
#include "compiler/front/chart_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/front/materials.hpp"

namespace wale {
namespace {

bool is_color(const std::string& text) {
  return text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

bool is_one_character(const std::string& text) {
  std::size_t characters = 0;
  for (const char c : text) characters += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  return characters == 1;
}

class YarnsReader {
 public:
  explicit YarnsReader(Diagnostics& say) : say_(say) {}

  ChartYarns read(const YamlNode& root) {
    const YamlNode* node = root.find("yarns");
    if (!node) {
      add({"main", {}}, {root.span.source, root.span.begin, root.span.begin});
      return std::move(result_);
    }
    if (node->kind != YamlNode::Kind::map || node->entries.empty()) {
      say_.error("Y004", node->span, "\"yarns\" must be a map from names to yarns",
                 "write `yarns: {main: {material: acrylic_16_2}}`");
      return std::move(result_);
    }
    for (const YamlEntry& entry : node->entries) read_yarn(entry);
    return std::move(result_);
  }

 private:
  void add(ChartYarn yarn, const Span& span) {
    if (is_one_character(yarn.name)) result_.by_symbol.emplace(yarn.name, static_cast<int>(result_.yarns.size()));
    result_.yarns.push_back(std::move(yarn));
    result_.stitch_lengths.emplace_back();
    result_.spans.push_back(span);
  }

  void read_yarn(const YamlEntry& entry) {
    ChartYarn yarn{entry.key, {}};
    if (entry.value.kind == YamlNode::Kind::scalar) {
      yarn.material = read_material(entry.value, entry.key, say_).value_or(Material{});
      add(std::move(yarn), entry.span);
      return;
    }
    add(std::move(yarn), entry.span);
    if (entry.value.kind == YamlNode::Kind::null) return;
    const Fields fields(entry.value, "a yarn", {"material", "color", "stitch_length", "symbol"}, say_);
    ChartYarn& added = result_.yarns.back();
    if (const YamlNode* material = fields.find("material")) {
      added.material = read_material(*material, entry.key, say_).value_or(Material{});
    }
    if (const YamlNode* color = fields.find("color")) read_color(*color, added);
    if (const YamlNode* length = fields.find("stitch_length")) read_length(*length);
    if (const YamlNode* symbol = fields.find("symbol")) read_symbol(*symbol);
  }

  void read_color(const YamlNode& node, ChartYarn& yarn) {
    if (node.kind == YamlNode::Kind::null) {
      say_.error("Y004", node.span, "the colour is missing",
                 "put it in quotes, as in `color: \"#c9b79c\"`: a bare # begins a comment");
      return;
    }
    const auto text = read_text(node, "a colour", say_);
    if (!text) return;
    if (is_color(*text)) {
      yarn.color = *text;
    } else {
      say_.error("Y008", node.span, fmt::format("\"{}\" is not a colour", *text), "write it as `color: \"#c9b79c\"`");
    }
  }

  void read_length(const YamlNode& node) {
    const auto value = read_quantity(node, "a stitch length", dimensions::length,
                                     {limits::least_stitch_length, limits::most_stitch_length}, say_);
    if (value) result_.stitch_lengths.back() = GivenLength{*value, node.span};
  }

  void read_symbol(const YamlNode& node) {
    const auto text = read_text(node, "a yarn's symbol", say_);
    if (!text) return;
    const int yarn = static_cast<int>(result_.yarns.size()) - 1;
    if (!is_one_character(*text) || *text == "#" || *text == " ") {
      say_.error("C010", node.span, fmt::format("\"{}\" cannot be a symbol", *text), "use one character, but not #");
    } else if (const auto [known, fresh] = result_.by_symbol.emplace(*text, yarn); !fresh && known->second != yarn) {
      say_.error("C010", node.span, fmt::format("the symbol \"{}\" already stands for another yarn", *text),
                 "use another character");
    }
  }

  ChartYarns result_;
  Diagnostics& say_;
};

}  // namespace

int ChartYarns::find(const std::string& name) const {
  for (std::size_t i = 0; i < yarns.size(); ++i) {
    if (yarns[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

ChartYarns read_yarns(const YamlNode& root, Diagnostics& say) { return YarnsReader(say).read(root); }

}  // namespace wale
