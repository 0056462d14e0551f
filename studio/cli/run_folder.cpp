#include "studio/cli/run_folder.hpp"

#include "sim/results/csv.hpp"
#include "sim/results/file.hpp"
#include "sim/results/hdf5.hpp"
#include "sim/results/moments.hpp"
#include "sim/results/picture.hpp"
#include "sim/results/shown_fabric.hpp"
#include "sim/results/stretch_strain.hpp"
#include "sim/results/summary.hpp"
#include "sim/results/vtk.hpp"

namespace wale {
namespace {

namespace fs = std::filesystem;

void write_fabric(const Results& results, const Snapshot& snapshot, ColourBy colour, const std::string& title,
                  const fs::path& path) {
  const Scene& scene = results.scene;
  const PictureOptions options{title, colour, rest_lengths_at(scene, snapshot), {}, 900};
  const Fabric shown = shown_fabric(scene.fabric, scene.gauge, snapshot.state.q);
  write_file(path.string(), fabric_svg(shown, shown.points, options));
}

/// A fabric that curls hides behind itself from the front.
void write_curl(const Results& results, const Snapshot& snapshot, const fs::path& path) {
  const Scene& scene = results.scene;
  const Fabric shown = shown_fabric(scene.fabric, scene.gauge, snapshot.state.q);
  const PictureOptions options{
      scene.name + ", along its axis", ColourBy::material, rest_lengths_at(scene, snapshot), {}, 900};
  write_file(path.string(), fabric_svg(shown, seen_along_axis(scene.fabric.cell->curls, shown.points), options));
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
  if (const Snapshot* relaxed = relaxed_state(results)) {
    write_fabric(results, *relaxed, ColourBy::material, name + ", relaxed", folder / "fabric_relaxed.svg");
    if (relaxed_curvature(results)) write_curl(results, *relaxed, folder / "fabric_curl.svg");
  }
  if (const Snapshot* pulled = pulled_state(results))
    write_fabric(results, *pulled, ColourBy::stretch, name + ", pulled", folder / "fabric_pulled.svg");
  const std::vector<LabelledCurve> curves = stress_strain_curves(results);
  if (!curves.empty()) write_file((folder / "curve.svg").string(), curve_svg(curves, name));
  write_frames(results, folder.string());
}

}  // namespace wale
