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
  if (a.cell.has_value() != b.cell.has_value()) return false;
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

std::optional<Results> begin_run(const std::string& scene_path) {
  Sources sources;
  const Source* source = read_or_complain(sources, scene_path);
  if (!source || is_knitout(*source)) return {};
  Diagnostics say;
  std::optional<Scene> scene;
  const double seconds = seconds_of([&] { scene = compile_scene(*source, sources, say); });
  print_all(say);
  if (!scene || say.failed()) return {};

  Results results;
  results.scene = std::move(*scene);
  results.manifest = manifest_of(sources);
  for (const Diagnostic& diagnostic : say.all()) results.warnings.push_back(diagnostic.message);
  results.phases.push_back({"compile", seconds});
  return results;
}

std::optional<Results> resume_run(const std::string& results_path) {
  Results results = read_hdf5(results_path);
  Sources sources;
  for (const Text& text : results.manifest.sources) sources.add(text.name, text.text);
  Diagnostics say;
  std::optional<Scene> scene;
  if (!sources.all().empty()) scene = compile_scene(sources.all().front(), sources, say);
  if (!scene || !same_fabric(scene->fabric, results.scene.fabric)) {
    print_all(say);
    complain(results_path, "the scene stored here no longer compiles to the fabric stored here",
             "begin anew with `wale run SCENE -o DIR`");
    return {};
  }
  scene->fabric = std::move(results.scene.fabric);
  results.scene = std::move(*scene);
  results.manifest.threads = omp_get_max_threads();
  return results;
}

}  // namespace wale
