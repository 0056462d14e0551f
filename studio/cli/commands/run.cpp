#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "compiler/front/scene.hpp"
#include "sim/results/file.hpp"
#include "sim/results/summary.hpp"
#include "studio/choice/report.hpp"
#include "studio/cli/closing.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/interrupt.hpp"
#include "studio/cli/progress_bar.hpp"
#include "studio/cli/report.hpp"
#include "studio/cli/run_folder.hpp"
#include "studio/cli/session.hpp"

namespace wale {
namespace {

using Clock = std::chrono::steady_clock;

// A program that is killed loses no more than this; one that is interrupted saves first, and loses nothing.
constexpr std::chrono::seconds between_saves{1};

struct RunCommand {
  std::string scene, out, resume, accuracy;
  bool progress = false, json = false;
  int threads = 0;
};

/// The run itself, and what was left to be tried after it.
Outcome simulate(Session& session, const std::filesystem::path& folder, const RunCommand& command,
                 const std::atomic<bool>& interrupt, Refining& after) {
  Results& results = session.results;
  ProgressBar bar(command.progress);
  double writing = 0;
  RunOptions options;
  options.progress = [&](const RunStatus& status) { bar.show(status); };
  std::optional<Clock::time_point> saved;
  options.save = [&](const Results& so_far) {
    if (saved && Clock::now() - *saved < between_saves) return;
    writing += seconds_of([&] { write_snapshots(so_far, folder); });
    saved = Clock::now();
  };
  options.interrupt = &interrupt;
  Outcome outcome = run(results, options);
  if (outcome != Outcome::interrupted) writing += seconds_of([&] { write_pictures(results, folder); });
  results.phases.push_back({"write", writing});
  write_tables(results, folder);
  if (outcome == Outcome::finished && wants_second_look(session.settled)) {
    after = look_and_refine(session.text(), session.settled, results, options,
                            [&](const SecondLook& before, const Settled& finer) {
                              bar.clear();
                              if (!command.json) fmt::print("{}", announcement(before, finer));
                              std::fflush(stdout);
                            });
    if (after.looks.size() > 1) write_pictures(results, folder);
    write_tables(results, folder);
    if (interrupt) outcome = Outcome::interrupted;
  }
  bar.clear();
  return outcome;
}

std::optional<double> accuracy_of(const std::string& text) {
  Sources sources;
  const Source* source = sources.add("--accuracy", text);
  Diagnostics say;
  const auto accuracy = read_accuracy(text, {source, 0, static_cast<std::uint32_t>(text.size())}, say);
  print_all(say);
  return accuracy;
}

int run_command(const RunCommand& command) {
  const bool resuming = !command.resume.empty();
  if (resuming == !command.scene.empty()) return complain("wale run", "a scene or --resume is wanted, one of the two");
  if (resuming && !command.accuracy.empty())
    return complain("wale run", "--resume goes on as it began", "leave out --accuracy");
  if (resuming && !command.out.empty()) return complain("wale run", "--resume writes where it reads: leave out -o");
  if (!resuming && command.out.empty()) return complain("wale run", "no place for the results", "add -o DIR");
  const std::atomic<bool>& interrupt = catch_interrupts();
  use_threads(command.threads);
  const std::filesystem::path folder = resuming ? command.resume : command.out;
  std::optional<double> accuracy;
  if (!command.accuracy.empty() && !(accuracy = accuracy_of(command.accuracy))) return bad_input;
  std::optional<Session> session =
      resuming ? resume_run((folder / results_name).string()) : begin_run(command.scene, accuracy);
  if (!session) return bad_input;
  const Results& results = session->results;
  try {
    prepare_folder(folder);
  } catch (const std::system_error& error) {
    return complain_unwritable(folder.string(), error);
  }
  if (!command.json) fmt::print("{}", words_of(session->settled));
  Refining after;
  const Outcome outcome = simulate(*session, folder, command, interrupt, after);
  if (leaves_open(session->settled))
    write_file((folder / "choices.json").string(), choices_json(session->settled, after));
  if (command.json) {
    fmt::print("{}", summary_json(results));
  } else {
    fmt::print("{}", closing_words(results, folder.string()));
    fmt::print("{}", words_of(after, session->settled));
  }
  return tell_outcome(results, outcome, folder.string());
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunCommand>();
  CLI::App* command = app.add_subcommand("run", "Runs a scene: compile, tighten, relax, pull");
  command->add_option("SCENE", options->scene, "A scene file");
  command->add_option("-o,--out", options->out, "The folder for the results");
  command->add_option("--accuracy", options->accuracy,
                      "Choose segments, sampling and tolerances for this error of the stress over its peak, as in 1%; "
                      "run anew, finer, if it is estimated to be more");
  command->add_option("--resume", options->resume, "Go on from the last snapshot in this folder");
  command->add_option("--threads", options->threads, "Threads to use; as many as the machine offers if not given")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--progress", options->progress, "Show progress on stderr even if that is no terminal");
  command->add_flag("--json", options->json, "Print the summary as one JSON object");
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace wale
