#include "studio/cli/session.hpp"

#include <fmt/chrono.h>
#include <omp.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <ctime>

#include "compiler/compile.hpp"
#include "sim/results/hdf5.hpp"
#include "sim/world.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/input.hpp"
#include "studio/cli/report.hpp"

namespace wale {
namespace {

Manifest manifest_of(const Sources& sources) {
  Manifest manifest;
  manifest.version = WALE_VERSION;
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) manifest.host = host.data();
  manifest.when = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  manifest.threads = omp_get_max_threads();
  for (const Source& source : sources.all()) manifest.sources.push_back({source.name, source.text});
  return manifest;
}

/// Equal but for the last digits, which another machine may round otherwise.
bool same_fabric(const Fabric& a, const Fabric& b) {
  constexpr double tolerance = 1e-9;  // m
  if (a.materials != b.materials || a.yarns.size() != b.yarns.size() || a.segments.size() != b.segments.size())
    return false;
  if (a.cell.has_value() != b.cell.has_value() || (a.cell && a.cell->curls != b.cell->curls)) return false;
  const Points p = at_rest(a).q, q = at_rest(b).q;
  return p.cols() == q.cols() && (p - q).norm() < tolerance;
}

}  // namespace

void use_threads(int count) {
  if (count > 0) omp_set_num_threads(count);
}

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::optional<Session> begin_run(const std::string& scene_path, std::optional<double> accuracy) {
  Session session;
  session.sources = std::make_unique<Sources>();
  const Source* source = read_or_complain(*session.sources, scene_path);
  if (!source || is_knitout(*source)) return {};
  Diagnostics say;
  std::optional<Settled> settled;
  const double seconds = seconds_of([&] { settled = settle(session.text(), accuracy, say); });
  print_all(say);
  if (!settled || say.failed()) return {};

  session.settled = std::move(*settled);
  Results& results = session.results;
  results.scene = std::move(session.settled.scene);
  results.manifest = manifest_of(*session.sources);
  if (session.settled.resolution) results.manifest.accuracy = session.settled.accuracy;
  for (const Diagnostic& diagnostic : say.all()) results.warnings.push_back(diagnostic.message);
  results.phases.push_back({"compile", seconds});
  return session;
}

std::optional<Session> resume_run(const std::string& results_path) {
  Session session;
  session.sources = std::make_unique<Sources>();
  Results& results = session.results = read_hdf5(results_path);
  for (const Text& text : results.manifest.sources) session.sources->add(text.name, text.text);
  const double asked = results.manifest.accuracy;
  Diagnostics say;
  std::optional<Settled> settled;
  if (!session.sources->all().empty())
    settled =
        settle(session.text(), asked > 0 ? std::optional(asked) : std::nullopt, say, results.manifest.refinements);
  if (!settled || !same_fabric(settled->scene.fabric, results.scene.fabric)) {
    print_all(say);
    complain(results_path, "the scene stored here no longer compiles to the fabric stored here",
             "begin anew with `wale run SCENE -o DIR`");
    return {};
  }
  session.settled = std::move(*settled);
  session.settled.scene.fabric = std::move(results.scene.fabric);
  results.scene = std::move(session.settled.scene);
  results.manifest.threads = omp_get_max_threads();
  return session;
}

}  // namespace wale
