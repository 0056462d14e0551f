#include "studio/cli/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(Bed bed) {
  switch (bed) {
    case Bed::front:
      return "f";
    case Bed::back:
      return "b";
    case Bed::front_slider:
      return "fs";
    case Bed::back_slider:
      break;
  }
  return "bs";
}

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

/// Loops still on each bed. No transfer follows the last course, so a loop hangs where it was made.
Json on_needles(const StitchGraph& graph) {
  Json held = {{"f", 0}, {"b", 0}, {"fs", 0}, {"bs", 0}};
  for (const Loop& loop : graph.loops) {
    if (loop.held)
      held[std::string(name_of(loop.needle.bed))] = held[std::string(name_of(loop.needle.bed))].get<int>() + 1;
  }
  return held;
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

Json counts(const Compiled& compiled) {
  const StitchGraph& graph = compiled.graph;
  const std::vector<Instruction>& code = compiled.program.code;
  const auto is_knit = [](const Loop& loop) { return loop.kind == LoopKind::knit; };
  const auto on_empty = [&](const Loop& loop) { return is_knit(loop) && loop.through.empty(); };
  const auto is_split = [](const Instruction& each) { return each.op == Op::split && !each.carriers.empty(); };
  const auto knits = std::count_if(graph.loops.begin(), graph.loops.end(), is_knit);
  std::size_t edges = 0;
  for (const Loop& loop : graph.loops) edges += loop.through.size();
  return {{"courses", compiled.chart.course_count()},
          {"wales", compiled.chart.wales()},
          {"instructions", code.size()},
          {"loops", graph.loops.size()},
          {"edges", edges},
          {"knits", knits},
          {"tucks", static_cast<long>(graph.loops.size()) - knits},
          {"splits", std::count_if(code.begin(), code.end(), is_split)},
          {"knits_on_empty", std::count_if(graph.loops.begin(), graph.loops.end(), on_empty)},
          {"on_needles", on_needles(graph)},
          {"yarns", graph.yarns.size()},
          {"carriers_in", carriers_in(compiled.program)}};
}

Json loops_json(const StitchGraph& graph) {
  std::vector<int> previous(graph.loops.size(), -1);
  for (const YarnPath& yarn : graph.yarns) {
    for (std::size_t i = 1; i < yarn.loops.size(); ++i)
      previous[static_cast<std::size_t>(yarn.loops[i])] = yarn.loops[i - 1];
  }
  LineNumbers line_of;
  Json list = Json::array();
  for (std::size_t id = 0; id < graph.loops.size(); ++id) {
    const Loop& loop = graph.loops[id];
    list.push_back({{"id", id},
                    {"carrier", graph.carriers[static_cast<std::size_t>(loop.carrier)]},
                    {"direction", sign_of(loop.direction)},
                    {"needle", fmt::format("{}{}", name_of(loop.needle.bed), loop.needle.index)},
                    {"line", line_of(loop.span)},
                    {"op", loop.kind == LoopKind::knit ? "knit" : "tuck"},
                    {"parents", loop.through},
                    {"previous", previous[id] < 0 ? Json() : Json(previous[id])}});
  }
  return list;
}

}  // namespace wale
