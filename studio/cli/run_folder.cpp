#include "studio/cli/run_folder.hpp"

#include "sim/results/csv.hpp"
#include "sim/results/file.hpp"
#include "sim/results/hdf5.hpp"
#include "sim/results/picture.hpp"
#include "sim/results/stretch_strain.hpp"
#include "sim/results/summary.hpp"
#include "sim/results/vtk.hpp"

namespace wale {
namespace {

namespace fs = std::filesystem;

void write_fabric(const Results& results, const Snapshot& snapshot, ColourBy colour, const std::string& title,
                  const fs::path& path) {
  const Scene& scene = results.scene;
  const PictureOptions options{title, colour, tightening_at(scene, snapshot), {}, 900};
  write_file(path.string(), fabric_svg(scene.fabric, snapshot.state.q, options));
}

/// The state that the first mount or pull begins from, and the last state of a pull; null if there is none.
struct Shown {
  const Snapshot *relaxed = nullptr, *pulled = nullptr;
};

Shown shown(const Results& results) {
  Shown found;
  bool gripped = false;
  for (const Snapshot& snapshot : results.snapshots) {
    const Stage& stage = results.scene.stages[static_cast<std::size_t>(snapshot.stage)];
    if (!gripped) found.relaxed = &snapshot;
    gripped = gripped || stage.mount || stage.pull;
    if (stage.pull && snapshot.sample != 0) found.pulled = &snapshot;
  }
  return found;
}

}  // namespace

void prepare_folder(const fs::path& folder) {
  fs::create_directories(folder);
  const std::string probe = (folder / results_name).string();
  open_part(probe);
  drop_part(probe);
}

void write_snapshots(const Results& results, const fs::path& folder) {
  write_hdf5(results, (folder / results_name).string());
}

void write_tables(const Results& results, const fs::path& folder) {
  write_csv(results, (folder / "curve.csv").string());
  write_summary(results, (folder / "summary.json").string());
  write_snapshots(results, folder);
}

void write_pictures(const Results& results, const fs::path& folder) {
  const std::string& name = results.scene.name;
  const Shown states = shown(results);
  if (states.relaxed)
    write_fabric(results, *states.relaxed, ColourBy::material, name + ", relaxed", folder / "fabric_relaxed.svg");
  if (states.pulled)
    write_fabric(results, *states.pulled, ColourBy::stretch, name + ", pulled", folder / "fabric_pulled.svg");
  const Curve curve = stress_strain(results);
  if (!curve.strain.empty()) write_file((folder / "curve.svg").string(), curve_svg({{"", curve}}, name));
  write_frames(results, folder.string());
}

}  // namespace wale
