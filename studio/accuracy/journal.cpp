#include "studio/accuracy/journal.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "sim/results/file.hpp"
#include "studio/accuracy/trial_json.hpp"

namespace wale {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string line_of(const Journal::Origin& origin) {
  Json sources = Json::array();
  for (const Source& source : origin.sources) sources.push_back({source.name, source.text});
  return line_of(
      Json{{"version", WALE_VERSION}, {"threads", origin.threads}, {"times", origin.times}, {"sources", sources}});
}

std::string line_of(const std::string& knob, const Trial& trial) {
  return line_of(Json{{"knob", knob}, {"trial", whole_json(trial)}});
}

}  // namespace

Journal::Journal(std::string path, const Origin& origin, bool resume) : path_(std::move(path)) {
  const std::string first = line_of(origin);
  if (resume) read(first);
  std::string lines = first;
  for (const Kept& each : kept_) lines += line_of(each.knob, each.trial);
  write_file(path_, lines);
}

std::optional<Trial> Journal::find(const std::string& knob, const std::string& label) const {
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& each) { return each.knob == knob && each.trial.label == label; });
  if (found == kept_.end()) return std::nullopt;
  return found->trial;
}

void Journal::keep(const std::string& knob, const Trial& trial) {
  kept_.push_back({knob, trial});
  append(line_of(knob, trial));
}

void Journal::read(const std::string& origin) {
  std::istringstream lines(read_file(path_));
  std::string line;
  std::getline(lines, line);
  if (line + "\n" != origin)
    throw std::runtime_error("what ran before was of another scene, version, number of threads or of times");
  while (std::getline(lines, line)) {
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) return;
    kept_.push_back({json.at("knob"), trial_from(json.at("trial"))});
  }
}

void Journal::append(const std::string& line) const {
  std::ofstream file(path_, std::ios::app | std::ios::binary);
  file << line << std::flush;
  if (!file) throw std::system_error(errno, std::generic_category(), path_);
}

}  // namespace wale
