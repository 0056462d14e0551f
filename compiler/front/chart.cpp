#include "compiler/fields.hpp"
#include "compiler/front/chart_parts.hpp"
#include "compiler/passes.hpp"

namespace wale::passes {
namespace {

bool is_chart(const YamlNode& root, Diagnostics& say) {
  const YamlNode* version = root.find("knit");
  if (version && version->text == "1") return true;
  const Span start{root.span.source, 0, 0};
  if (version) {
    say.error("C001", version->span, "this chart is of a version that nobody knows", "write `knit: 1`");
  } else if (root.find("scene")) {
    say.error("C001", start, "this is a scene, not a chart", "run a scene with `wale run`");
  } else {
    say.error("C001", start, "this is not a chart", "begin a chart with `knit: 1`");
  }
  return false;
}

void set_materials(std::vector<ChartYarn>& yarns, const YarnMaterials& given, Diagnostics& say) {
  std::vector<std::string> names;
  std::vector<Material> own;
  for (const ChartYarn& yarn : yarns) {
    names.push_back(yarn.name);
    own.push_back(yarn.material);
  }
  const std::vector<Material> chosen = materials_of(names, given, std::move(own), "yarn", say);
  for (std::size_t i = 0; i < yarns.size(); ++i) yarns[i].material = chosen[i];
}

std::optional<Chart> read_chart(const Source& source, const ChartOverrides& overrides, Diagnostics& say) {
  const std::size_t errors_before = say.error_count();
  const std::optional<YamlNode> root = parse_yaml(source, say);
  if (!root || !is_chart(*root, say)) return std::nullopt;
  const Fields fields(*root, "a chart",
                      {"knit", "name", "form", "wales", "yarns", "symbols", "patterns", "bands", "stitch_length",
                       "gauge", "edges", "first_row", "view", "colorwork"},
                      say);
  const ChartHead head = read_head(*root, overrides, say);
  const Legend legend = read_legend(*root, say);
  ChartYarns yarns = read_yarns(*root, say);
  const Patterns patterns = read_patterns(*root, legend, say);
  set_materials(yarns.yarns, overrides.materials, say);
  fields.require("bands", "add `bands:` with one line a band, as in `- {stitch: jersey, courses: 12}`");
  std::vector<Band> bands = read_bands(*root, {legend, patterns, yarns}, say);
  if (say.error_count() > errors_before) return std::nullopt;
  return lay_out(head, yarns, std::move(bands), overrides, say);
}

}  // namespace

std::optional<Chart> parse_chart(const Source& source, const ChartOverrides& overrides, Diagnostics& say) {
  const std::size_t before = say.all().size();
  std::optional<Chart> chart = read_chart(source, overrides, say);
  say.order_by_place(before);
  return chart;
}

}  // namespace wale::passes
