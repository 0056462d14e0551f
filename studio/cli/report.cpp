#include "studio/cli/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

std::string_view sign_of(Direction direction) {
  if (direction == Direction::none) return "";
  return direction == Direction::increasing ? "+" : "-";
}

/// Carriers that came in and did not go out.
long carriers_in(const Program& program) {
  std::vector<bool> in(program.carriers.size());
  for (const Instruction& instruction : program.code) {
    const bool comes = instruction.op == Op::in || instruction.op == Op::inhook;
    const bool goes = instruction.op == Op::out || instruction.op == Op::outhook;
    if (!comes && !goes) continue;
    for (const int carrier : instruction.carriers) in[static_cast<std::size_t>(carrier)] = comes;
  }
  return std::count(in.begin(), in.end(), true);
}

Json on_needles(const StitchGraph& graph) {
  std::array<std::size_t, 4> held{};  // by Bed
  for (const HeldLoops& needle : graph.on_needles)
    held[static_cast<std::size_t>(needle.needle.bed)] += needle.loops.size();
  return {{"f", held[0]}, {"b", held[1]}, {"fs", held[2]}, {"bs", held[3]}};
}

std::string_view operation_of(const Loop& loop, const Program& program) {
  if (loop.kind == LoopKind::tuck) return "tuck";
  return program.code[static_cast<std::size_t>(loop.instruction)].op == Op::split ? "split" : "knit";
}

struct Stitches {
  long knits = 0, tucks = 0, splits = 0, on_empty = 0;
};

Stitches count_stitches(const Program& program, const StitchGraph& graph) {
  Stitches count;
  for (const Loop& loop : graph.loops) {
    if (loop.kind == LoopKind::tuck)
      ++count.tucks;
    else if (loop.through.empty())
      ++count.on_empty;
    else
      ++(operation_of(loop, program) == "split" ? count.splits : count.knits);
  }
  return count;
}

}  // namespace

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      break;
  }
  return "error";
}

void print_all(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    std::string text = print(diagnostic);
    if (!text.ends_with('\n')) text += '\n';
    fmt::print(stderr, "{}", text);
  }
  for (const auto& [code, count] : diagnostics.counts())
    if (count > Diagnostics::most_of_a_code)
      fmt::print(stderr, "and {} more [{}]\n", count - Diagnostics::most_of_a_code, code);
}

std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json to_json(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const bool placed = diagnostic.span.source != nullptr;
    const LineColumn at = placed ? locate(diagnostic.span) : LineColumn{};
    list.push_back({{"severity", name_of(diagnostic.severity)},
                    {"code", diagnostic.code},
                    {"file", placed ? diagnostic.span.source->name : ""},
                    {"line", at.line},
                    {"column", at.column},
                    {"message", diagnostic.message},
                    {"hint", diagnostic.hint}});
  }
  return list;
}

Json counts(const Program& program, const StitchGraph& graph) {
  const Stitches stitches = count_stitches(program, graph);
  std::size_t edges = 0;
  for (const Loop& loop : graph.loops) edges += loop.through.size();
  const std::vector<int> courses = courses_of(graph);
  return {{"courses", courses.empty() ? 0 : *std::max_element(courses.begin(), courses.end()) + 1},
          {"wales", graph.widest},
          {"instructions", program.code.size()},
          {"loops", graph.loops.size()},
          {"edges", edges},
          {"knits", stitches.knits},
          {"tucks", stitches.tucks},
          {"splits", stitches.splits},
          {"knits_on_empty", stitches.on_empty},
          {"on_needles", on_needles(graph)},
          {"yarns", graph.yarns.size()},
          {"carriers_in", carriers_in(program)}};
}

Json loops_json(const Program& program, const StitchGraph& graph) {
  std::vector<int> previous(graph.loops.size(), -1);
  for (const YarnPath& yarn : graph.yarns) {
    for (std::size_t i = 1; i < yarn.loops.size(); ++i)
      previous[static_cast<std::size_t>(yarn.loops[i])] = yarn.loops[i - 1];
  }
  Locator locate_loop;
  Json list = Json::array();
  for (std::size_t id = 0; id < graph.loops.size(); ++id) {
    const Loop& loop = graph.loops[id];
    list.push_back({{"id", id},
                    {"carrier", graph.carriers[static_cast<std::size_t>(loop.carrier)]},
                    {"direction", sign_of(loop.direction)},
                    {"needle", print(loop.needle)},
                    {"line", locate_loop(loop.span).line},
                    {"op", operation_of(loop, program)},
                    {"parents", loop.through},
                    {"previous", previous[id] < 0 ? Json() : Json(previous[id])}});
  }
  return list;
}

}  // namespace wale
