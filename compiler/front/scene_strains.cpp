#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compiler/fields.hpp"
#include "compiler/front/scene_parts.hpp"

namespace wale {
namespace {

constexpr std::string_view example_pull =
    "say along what: `pull: {along: wale, to: 60 %}` or `{along: course, to: 60 %}`";
constexpr std::string_view each_differs =
    "write each strain other than the one before it, and the first other than 0 %";

constexpr double longest = 20;
constexpr Range swatch_strain{1e-6, longest}, swatch_turn{0, longest};  // a swatch that is pushed together buckles
constexpr Range period_strain{-0.9, longest}, shear_strain{-longest, longest};
constexpr Range bend{-1e4, 1e4};  // 1/m, a tenth of a millimetre around

/// What a deformation is measured by.
struct Measure {
  std::string_view name;
  const Dimension& dimension;
};
constexpr Measure strain{"the strain", dimensions::ratio}, curvature{"the curvature", dimensions::curvature};

/// One strain, or a list of them; what is faulty is reported and left out.
std::vector<double> read_strains(const YamlNode& node, Range alone, Range in_list, Diagnostics& say,
                                 const Measure& measure = strain) {
  std::vector<double> strains;
  const auto read = [&](const YamlNode& item, Range range) {
    if (const auto value = read_quantity(item, measure.name, measure.dimension, range, say)) strains.push_back(*value);
  };
  if (node.kind != YamlNode::Kind::list) {
    read(node, alone);
    return strains;
  }
  for (const YamlNode& item : node.items) read(item, in_list);
  if (node.items.empty())
    say.error("Y004", node.span, "this list of strains is empty", "write `[60 %, 0 %]`, or one strain");
  return strains;
}

/// The text of the k-th strain.
Span place(const YamlNode& node, std::size_t k) {
  return node.kind == YamlNode::Kind::list && k < node.items.size() ? node.items[k].span : node.span;
}

bool stands_still(const std::vector<double>& strains, std::size_t k) {
  return strains[k] == (k > 0 ? strains[k - 1] : 0);
}

void check_moves(const std::vector<double>& strains, const YamlNode& node, Diagnostics& say) {
  for (std::size_t k = 0; k < strains.size(); ++k) {
    if (!stands_still(strains, k)) continue;
    say.error("S011", place(node, k), fmt::format("{} is there already", strain.name), std::string(each_differs));
    return;
  }
}

Deform::Part read_part(const YamlNode& node, std::string_view key, Range range, const Measure& measure,
                       Diagnostics& say) {
  const bool word = node.kind == YamlNode::Kind::scalar && !node.text.empty() &&
                    std::isalpha(static_cast<unsigned char>(node.text.front()));
  if (!word) return {Deform::How::driven, read_strains(node, range, range, say, measure)};
  const auto how = read_word(node, fmt::format("\"{}\"", key), {"free", "held"}, say);
  return {how.value_or(0) == 1 ? Deform::How::held : Deform::How::free, {}};
}

struct DrivenPart {
  const YamlNode* node = nullptr;
  std::string_view key;
  const std::vector<double>* strains = nullptr;
  std::string_view measure;
  bool from_zero = true;  ///< where it begins is known
  bool rests(std::size_t k) const { return (k > 0 || from_zero) && stands_still(*strains, k); }
};

/// All driven parts reach their strains together, and something moves every time.
void check_together(const std::vector<DrivenPart>& driven, Diagnostics& say) {
  if (driven.empty()) return;
  const DrivenPart& first = driven.front();
  for (const DrivenPart& part : driven) {
    if (part.strains->size() == first.strains->size()) continue;
    say.error("S011", part.node->span,
              fmt::format("the list of \"{}\" is {} long, that of \"{}\" {}", part.key, part.strains->size(), first.key,
                          first.strains->size()),
              "give as many to both: they are reached together; repeat a strain where one of the two rests");
    return;
  }
  for (std::size_t k = 0; k < first.strains->size(); ++k) {
    if (!std::all_of(driven.begin(), driven.end(), [k](const DrivenPart& part) { return part.rests(k); })) continue;
    say.error("S011", place(*first.node, k), fmt::format("{} is there already", first.measure),
              std::string(each_differs) + "; `held` keeps a period as it is");
    return;
  }
}

}  // namespace

std::optional<Pull> read_pull(const YamlNode& node, bool periodic, Diagnostics& say) {
  if (node.kind == YamlNode::Kind::scalar) {
    say.error("S003", node.span, fmt::format("a strain of \"{}\" has no direction", node.text),
              std::string(example_pull));
    return std::nullopt;
  }
  const Fields fields(node, "a pull", {"along", "to"}, say);
  if (!fields.is_map()) return std::nullopt;
  Pull pull;
  if (const YamlNode* along = fields.find("along")) {
    const auto word = read_word(*along, "the direction of a pull", {"wale", "course"}, say);
    pull.along = word.value_or(0) == 0 ? Along::wale : Along::course;
  } else {
    say.error("S003", node.span, "this strain has no direction", std::string(example_pull));
  }
  if (const YamlNode* to = fields.require("to", "add the strain to reach, as in `to: 60 %`")) {
    pull.strains = periodic ? read_strains(*to, period_strain, period_strain, say)
                            : read_strains(*to, swatch_strain, swatch_turn, say);
    check_moves(pull.strains, *to, say);
  }
  return pull;
}

Deform read_deform(const YamlNode& node, Diagnostics& say) {
  const Fields fields(node, "a deformation", {"wale", "course", "shear", "curl"}, say);
  Deform deform;
  std::vector<DrivenPart> driven;
  const auto read = [&](std::string_view key, Range range, Deform::Part& part, const Measure& measure = strain) {
    const YamlNode* given = fields.find(key);
    if (!given) return;
    part = read_part(*given, key, range, measure, say);
    if (part.how == Deform::How::driven && !part.strains.empty())
      driven.push_back({given, key, &part.strains, measure.name, &part != &deform.curl});
  };
  read("wale", period_strain, deform.wale);
  read("course", period_strain, deform.course);
  read("shear", shear_strain, deform.shear);
  read("curl", bend, deform.curl, curvature);
  check_together(driven, say);
  return deform;
}

}  // namespace wale
