#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/spelling.hpp"
#include "sim/results/file.hpp"
#include "studio/accuracy/journal.hpp"
#include "studio/accuracy/report.hpp"
#include "studio/accuracy/sentences.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/input.hpp"
#include "studio/cli/interrupt.hpp"
#include "studio/cli/report.hpp"
#include "studio/cli/run_folder.hpp"
#include "studio/cli/session.hpp"

namespace wale {
namespace {

struct AccuracyCommand {
  std::string scene, out;
  std::vector<std::string> knobs;
  bool progress = false, json = false, list = false, resume = false;
  int threads = 1, times = 1;
};

/// A scene read and compiled as its file says. Nothing, and said on stderr, if that cannot be.
struct Read {
  Sources sources;
  const Source* source = nullptr;
  std::optional<ParsedScene> parsed;
  std::optional<Scene> scene;
  bool of_chart = true;
};

std::unique_ptr<Read> read_scene(const std::string& path) {
  auto read = std::make_unique<Read>();
  read->source = read_or_complain(read->sources, path);
  if (!read->source || is_knitout(*read->source)) return nullptr;
  Diagnostics say;
  read->scene = SceneText(*read->source, read->sources).compile({}, say);
  print_all(say);
  if (!read->scene || say.failed()) return nullptr;
  Diagnostics said_before;
  read->parsed = parse_scene(*read->source, said_before);
  read->of_chart = !holds_knitout(*read_pattern(*read->parsed, read->sources, said_before));
  return read;
}

int list_knobs(const std::vector<Knob>& knobs) {
  for (const Knob& knob : knobs) {
    std::string values;
    for (const Rung& rung : knob.rungs)
      values += fmt::format("{}{}{}", values.empty() ? "" : ", ", rung.label, rung.as_written ? " (as written)" : "");
    fmt::print("{:<20} {}{}\n", knob.key, values, knob.by_request ? "; only by --knob" : "");
  }
  return success;
}

int refuse_unknown(const std::vector<std::string>& wanted, const std::vector<Knob>& knobs) {
  std::vector<std::string_view> keys;
  for (const Knob& knob : knobs) keys.push_back(knob.key);
  for (const std::string& key : wanted)
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      return complain("wale accuracy", fmt::format("this scene has no knob \"{}\"", key), suggest(key, keys));
  return success;
}

void keep_asked_for(std::vector<Knob>& knobs, const std::vector<std::string>& keys) {
  std::erase_if(knobs, [&](const Knob& knob) {
    return keys.empty() ? knob.by_request : std::find(keys.begin(), keys.end(), knob.key) == keys.end();
  });
}

void write(const Study& study, const std::filesystem::path& folder) {
  write_file((folder / "accuracy.csv").string(), accuracy_csv(study));
  write_file((folder / "accuracy.json").string(), accuracy_json(study));
  write_file((folder / "accuracy.html").string(), accuracy_html(study));
}

void print_words(const Study& study, const std::string& folder) {
  fmt::print("{}\n\n", summary_sentence(study));
  for (const Ladder& ladder : study.ladders) {
    fmt::print("{:<20} {}\n", ladder.key, sentence(ladder));
    if (ladder.observed_order)
      fmt::print("{:<20} order {:.1f}{}\n", "", *ladder.observed_order,
                 ladder.expected_order ? fmt::format(", {:g} expected", *ladder.expected_order) : "");
  }
  fmt::print("\nIn {}: accuracy.html (diagrams), accuracy.csv, accuracy.json, trials.jsonl (for --resume)\n", folder);
}

/// Says which trial runs: always on a terminal, elsewhere if wanted.
auto progress_line(bool wanted) {
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  return [=](int done, int of, const std::string& what) {
    if (terminal)
      fmt::print(stderr, "\r\x1b[K{}/{}  {}", done + 1, of, what);
    else if (wanted)
      fmt::print(stderr, "{}/{}  {}\n", done + 1, of, what);
    std::fflush(stderr);
  };
}

/// The trials of the folder, from before if they are to be gone on with. Nothing, and said on stderr, if they cannot.
std::optional<Journal> open_journal(const AccuracyCommand& command, const Read& read) {
  const std::string path = (std::filesystem::path(command.out) / "trials.jsonl").string();
  const auto& texts = read.sources.all();
  if (command.resume && !std::filesystem::exists(path)) {
    complain(path, "there is no study to go on with", "leave out --resume to begin anew");
    return std::nullopt;
  }
  try {
    return Journal(path, {{texts.begin(), texts.end()}, command.threads, command.times}, command.resume);
  } catch (const std::system_error& error) {
    complain_unwritable(path, error);
  } catch (const std::runtime_error& error) {
    complain(path, error.what(), "leave out --resume to begin anew");
  } catch (const nlohmann::json::exception&) {
    complain(path, "this was not written by wale", "leave out --resume to begin anew");
  }
  return std::nullopt;
}

int accuracy_command(const AccuracyCommand& command) {
  const std::atomic<bool>& interrupt = catch_interrupts();
  use_threads(command.threads);
  const auto read = read_scene(command.scene);
  if (!read) return bad_input;
  std::vector<Knob> knobs = knobs_of(*read->parsed, *read->scene, read->of_chart);
  if (command.list) return list_knobs(knobs);
  if (command.out.empty()) return complain("wale accuracy", "no place for the results", "add -o DIR");
  if (refuse_unknown(command.knobs, knobs) != success) return bad_input;
  try {
    prepare_folder(command.out);
  } catch (const std::system_error& error) {
    return complain_unwritable(command.out, error);
  }
  keep_asked_for(knobs, command.knobs);
  std::optional<Journal> journal = open_journal(command, *read);
  if (!journal) return bad_input;
  const StudyOptions options{command.times, progress_line(command.progress), &interrupt,
                             [&](const Knob& knob, const Rung& rung) { return journal->find(knob.key, rung.label); },
                             [&](const Knob& knob, const Trial& trial) { journal->keep(knob.key, trial); }};
  const Study done = study(SceneText(*read->source, read->sources), read->scene->name, std::move(knobs),
                           all_together(*read->parsed), options);
  if (::isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\x1b[K");
  write(done, command.out);
  if (command.json)
    fmt::print("{}", accuracy_json(done));
  else
    print_words(done, command.out);
  if (!done.complete)
    fmt::print(stderr, "Interrupted; what had run is in {}. Go on with the same command and --resume\n", command.out);
  return done.complete ? success : interrupted;
}

}  // namespace

void add_accuracy(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<AccuracyCommand>();
  CLI::App* command = app.add_subcommand("accuracy", "Shows what accuracy costs: runs a scene with every knob turned");
  command->add_option("SCENE", options->scene, "A scene file")->required();
  command->add_option("-o,--out", options->out,
                      "The folder for accuracy.html, accuracy.csv, accuracy.json and trials.jsonl");
  command->add_option("--knob", options->knobs, "Turn only these, and those all together");
  command->add_flag("--list", options->list, "Print the knobs that this scene has, and run nothing");
  command->add_flag("--resume", options->resume, "Go on with a study that stopped in this folder, or add knobs to it");
  command->add_option("--times", options->times, "Runs of each, of which medians are told")->check(CLI::Range(1, 100));
  command->add_option("--threads", options->threads, "Threads to use; 1 if not given")->check(CLI::Range(1, 1024));
  command->add_flag("--progress", options->progress, "Show progress on stderr even if that is no terminal");
  command->add_flag("--json", options->json, "Print accuracy.json");
  command->callback([options, &exit_code] { exit_code = accuracy_command(*options); });
}

}  // namespace wale
