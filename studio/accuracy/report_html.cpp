#include <fmt/format.h>

#include <cmath>

#include "sim/results/svg.hpp"
#include "studio/accuracy/report.hpp"
#include "studio/accuracy/sentences.hpp"
#include "studio/accuracy/work_precision_picture.hpp"

namespace wale {
namespace {

using svg::escape;

constexpr std::string_view style = R"(<style>
body { font: 16px/1.5 Helvetica, Arial, sans-serif; color: #222; max-width: 1000px; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px } td, th { padding: 3px 10px; text-align: right }
th { border-bottom: 1px solid #888; font-weight: 600 } td:first-child, th:first-child { text-align: left }
tr.written { background: #f4efe4 } td.bad { color: #a33 } svg { max-width: 100%; height: auto }
h2 { margin-top: 2em } .note { color: #666 }
</style>)";

enum class Against : std::uint8_t { reference, own };

std::vector<WorkPrecisionLine> lines_of(const Study& study, Against against) {
  std::vector<WorkPrecisionLine> lines;
  for (const Ladder& ladder : study.ladders) {
    const bool choice = ladder.kind == Knob::Kind::choice;
    if (choice && against == Against::own) continue;
    WorkPrecisionLine line{ladder.key, {}, !choice};
    for (const Trial& trial : ladder.trials) {
      if (!trial.found) continue;
      const Errors& errors = against == Against::own ? trial.own_error : trial.error;
      line.marks.push_back(
          {{trial.cost.processor, headline(errors)}, trial.label, trial.rests_elsewhere || !trial.found->intact});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string order(const std::optional<double>& value) { return value ? fmt::format("{:.1f}", *value) : "–"; }

std::string sentences(const Study& study) {
  std::string html =
      "<table><tr><th>knob</th><th>order expected</th><th>observed</th><th style=\"text-align:left\">"
      "what it costs</th></tr>\n";
  for (const Ladder& ladder : study.ladders)
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td style=\"text-align:left\">{}</td></tr>\n",
                        escape(ladder.key), order(ladder.expected_order), order(ladder.observed_order),
                        escape(sentence(ladder)));
  return html + "</table>\n";
}

std::string row(const Trial& trial) {
  std::string html =
      fmt::format("<tr{}><td>{}</td><td>{:.3g}</td><td>{}</td><td>{}</td><td>{:.0f}</td>",
                  trial.as_written ? " class=\"written\"" : "", escape(trial.label), trial.cost.processor,
                  trial.cost.evaluations, trial.cost.factorizations, trial.cost.memory);
  if (!trial.found)
    return html + fmt::format("<td class=\"bad\" colspan=\"{}\" style=\"text-align:left\">{}</td></tr>\n",
                              readings.size() + 1, escape(trial.failure));
  html += fmt::format("<td>{}</td>", percent(headline(trial.own_error)));
  for (const double error : trial.error)
    html += fmt::format("<td{}>{}</td>", trial.rests_elsewhere ? " class=\"bad\"" : "",
                        std::isfinite(error) ? percent(error) : "–");
  return html + "</tr>\n";
}

std::string table(const Ladder& ladder) {
  std::string html = fmt::format(
      "<h3>{}</h3>\n<table><tr><th>{}</th><th>time, s</th><th>evaluations</th><th>factors</th>"
      "<th>MB</th><th>alone</th>",
      escape(ladder.key), escape(ladder.noun));
  for (const std::string_view reading : readings) {
    std::string key(reading);
    for (char& letter : key)
      if (letter == '_') letter = ' ';
    html += fmt::format("<th>{}</th>", key);
  }
  html += "</tr>\n";
  for (const Trial& trial : ladder.trials) html += row(trial);
  return html + "</table>\n";
}

constexpr std::string_view how_to_read = R"(<p class="note">One knob is turned at a time, the others stay as the scene's
file says; <em>together</em> turns all knobs of resolution at once. A run is made twice: as a whole, for its time, and
from the rest of the scene as written, for its errors, so that several ways to rest do not mix. Hollow marks rest in another of several equilibria
(their spacings are more than 5 % off), or yarn has passed through yarn. The largest difference in stress is given over
the peak; all other numbers over themselves, places of the yarn over its diameter. <em>Alone</em> is the error in stress
that this knob makes by itself: against its own finest value, for which it is Richardson's estimate. Of a choice it is
the change from the scene as written. Times are of the processor.</p>
)";

}  // namespace

std::string accuracy_html(const Study& study) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}: what accuracy costs</title>\n{1}"
      "</head><body>\n<h1>{0}: what accuracy costs</h1>\n<p>{2}</p>\n<p>{3} thread{4}, {5}.{6}</p>\n",
      escape(study.scene), style, escape(summary_sentence(study)), study.threads, study.threads == 1 ? "" : "s",
      study.times == 1 ? "one run each" : fmt::format("medians of {} runs each", study.times),
      study.complete ? "" : " Interrupted: some runs are missing.");
  html += how_to_read;
  html += work_precision_svg(lines_of(study, Against::reference), "Error against the reference");
  html += work_precision_svg(lines_of(study, Against::own), "Error of each knob by itself");
  html += "<h2>Knob by knob</h2>\n" + sentences(study) + "<h2>Every run</h2>\n";
  for (const Ladder& ladder : study.ladders) html += table(ladder);
  return html + "</body></html>\n";
}

}  // namespace wale
