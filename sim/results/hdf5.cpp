#include "sim/results/hdf5.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include "sim/results/file.hpp"
#include "sim/results/hdf5_archive.hpp"

namespace wale {
namespace {

using hdf5::Group;
using hdf5::Reader;
using hdf5::Writer;

constexpr const char* results_format = "wale results 1";
constexpr const char* fabric_format = "wale fabric 1";

// Each function below describes one group once; an Archive is a Writer of const things or a Reader of things.

/// Both periods, course and wale; a fabric that is not periodic has no such dataset.
void describe_cell(const Writer& in, const std::optional<PeriodicCell>& cell) {
  if (!cell) return;
  Points periods(3, 2);
  periods << cell->course, cell->wale;
  in.points("periods", "m", periods);
  in.value("curls", static_cast<long>(cell->curls));
}

void describe_cell(const Reader& in, std::optional<PeriodicCell>& cell) {
  if (!in.group().has("periods")) return;
  Points periods;
  in.points("periods", "m", periods);
  if (periods.cols() != 2) throw std::runtime_error("HDF5 file has a wrong shape of periods");
  cell = PeriodicCell{periods.col(0), periods.col(1)};
  long curls = 0;
  if (in.group().has("curls")) in.value("curls", curls);
  if (curls < 0 || curls > static_cast<long>(Curls::about_wales))
    throw std::runtime_error("HDF5 file has a fabric that curls as none does");
  cell->curls = static_cast<Curls>(curls);
}

/// Whether a member is there that older files lack.
bool has(const Writer&, const char*) { return true; }
bool has(const Reader& in, const char* name) { return in.group().has(name); }

template <class Archive, class AnyFabric>
void describe_fabric(Archive in, AnyFabric& fabric) {
  auto materials = in.group("materials");
  materials.field("name", "", fabric.materials, &Material::name);
  materials.field("linear_density", "kg/m", fabric.materials, &Material::linear_density);
  materials.field("axial_stiffness", "N", fabric.materials, &Material::axial_stiffness);
  materials.field("bending_rigidity", "N m2", fabric.materials, &Material::bending_rigidity);
  materials.field("diameter", "m", fabric.materials, &Material::diameter);
  materials.field("law", "", fabric.materials, &Material::law);
  materials.field("contact_stiffness", "N/m", fabric.materials, &Material::contact_stiffness);
  materials.field("core_diameter", "m", fabric.materials, &Material::core_diameter);
  materials.field("shell_exponent", "", fabric.materials, &Material::shell_exponent);
  auto yarns = in.group("yarns");
  yarns.field("first_point", "", fabric.yarns, &Yarn::first_point);
  yarns.field("first_segment", "", fabric.yarns, &Yarn::first_segment);
  yarns.field("segments", "", fabric.yarns, &Yarn::segments);
  auto segments = in.group("segments");
  segments.field("yarn", "", fabric.segments, &Segment::yarn);
  segments.field("material", "", fabric.segments, &Segment::material);
  segments.field("stitch", "", fabric.segments, &Segment::stitch);
  segments.field("length", "m", fabric.segments, &Segment::length);
  segments.field("knitted", "m", fabric.segments, &Segment::knitted);
  if (has(segments, "column")) {
    in.value("source", fabric.source);
    segments.field("line", "", fabric.segments, &Segment::line);
    segments.field("column", "", fabric.segments, &Segment::column);
  }
  in.points("points", "m", fabric.points);
  describe_cell(in, fabric.cell);
}

template <class Archive, class AnyScene>
void describe_scene(Archive in, AnyScene& scene) {
  in.value("name", scene.name);
  describe_fabric(in.group("fabric"), scene.fabric);
  auto gauge = in.group("gauge");
  gauge.list("bottom", "", scene.gauge.wale_ends[0]);
  gauge.list("top", "", scene.gauge.wale_ends[1]);
  gauge.list("left", "", scene.gauge.course_ends[0]);
  gauge.list("right", "", scene.gauge.course_ends[1]);
  gauge.value("wales", scene.gauge.wales);
  gauge.value("courses", scene.gauge.courses);
  gauge.measure("thickness", "m", scene.gauge.thickness);
  auto clamps = in.group("clamps");
  clamps.field("yarn", "", scene.clamps, &Clamp::yarn);
  clamps.field("at_end", "", scene.clamps, &Clamp::at_end);
  clamps.field("position", "", scene.clamps, &Clamp::position);
  clamps.field("direction", "", scene.clamps, &Clamp::direction);
  auto crossings = in.group("crossings");
  crossings.field("side_first", "", scene.crossings, &Crossing::side_first);
  crossings.field("side_last", "", scene.crossings, &Crossing::side_last);
  crossings.field("loop_first", "", scene.crossings, &Crossing::loop_first);
  crossings.field("loop_last", "", scene.crossings, &Crossing::loop_last);
  crossings.field("sign", "", scene.crossings, &Crossing::sign);
}

template <class Archive, class AnyResults>
void describe_report(Archive in, AnyResults& results) {
  in.value("complete", results.complete);
  in.value("contact_samples", results.contact_samples);
  in.list("warnings", "", results.warnings);
  auto manifest = in.group("manifest");
  manifest.value("version", results.manifest.version);
  manifest.value("host", results.manifest.host);
  manifest.value("when", results.manifest.when);
  manifest.value("threads", results.manifest.threads);
  if (has(manifest, "accuracy")) manifest.measure("accuracy", "1", results.manifest.accuracy);
  if (has(manifest, "refinements")) manifest.value("refinements", results.manifest.refinements);
  manifest.field("source_name", "", results.manifest.sources, &Text::name);
  manifest.field("source_text", "", results.manifest.sources, &Text::text);
  auto phases = in.group("phases");
  phases.field("name", "", results.phases, &Phase::name);
  phases.field("seconds", "s", results.phases, &Phase::seconds);
  auto relaxed = in.group("relaxed");
  relaxed.measure("course_spacing", "m", results.relaxed.course_spacing);
  relaxed.measure("wale_spacing", "m", results.relaxed.wale_spacing);
  relaxed.measure("width", "m", results.relaxed.width);
  relaxed.measure("length", "m", results.relaxed.length);
  relaxed.measure("thickness", "m", results.relaxed.thickness);
  auto effort = in.group("effort");
  effort.value("accepted", results.effort.accepted);
  effort.value("rejected", results.effort.rejected);
  effort.value("evaluations", results.effort.evaluations);
  if (has(effort, "spared")) effort.measure("spared", "1", results.effort.spared);
  effort.value("factorizations", results.effort.factorizations);
  effort.value("failure", results.effort.failure);
  if (has(in, "retries")) {
    auto retries = in.group("retries");
    retries.value("halved", results.effort.retries.halved);
    retries.value("continued", results.effort.retries.continued);
    retries.value("damped", results.effort.retries.damped);
    if (has(retries, "detoured")) retries.value("detoured", results.effort.retries.detoured);
  }
  auto topology = in.group("topology");
  topology.value("expected", results.topology.expected);
  topology.value("found", results.topology.found);
}

/// A slash would make a group of a column's name.
std::string column_place(std::string name) {
  std::replace(name.begin(), name.end(), '/', ':');
  return name;
}

void describe_samples(const Writer& in, const Table& table) {
  std::vector<std::string> names;
  for (const Column& column : table.columns) {
    names.push_back(column.name);
    in.list(column_place(column.name), column.unit, column.values);
  }
  in.list("columns", "", names);
}

void describe_samples(const Reader& in, Table& table) {
  std::vector<std::string> names;
  in.list("columns", "", names);
  for (const std::string& name : names) {
    Column column{name, in.group().unit(column_place(name)), {}};
    in.list(column_place(name), "", column.values);
    table.columns.push_back(std::move(column));
  }
}

/// The matrices `member` of all snapshots, snapshots x points x 3.
void stack(const Writer& in, const std::string& name, const std::string& unit, const std::vector<Snapshot>& snapshots,
           Points State::*member) {
  const Eigen::Index columns = snapshots.empty() ? 0 : (snapshots.front().state.*member).cols();
  std::vector<double> all;
  for (const Snapshot& snapshot : snapshots) {
    const Points& points = snapshot.state.*member;
    if (points.cols() != columns) throw std::invalid_argument("snapshots with different numbers of control points");
    all.insert(all.end(), points.data(), points.data() + points.size());
  }
  in.group().write_block(name, all.data(), {snapshots.size(), static_cast<hsize_t>(columns), 3}, unit, true);
}

void stack(const Reader& in, const std::string& name, const std::string&, std::vector<Snapshot>& snapshots,
           Points State::*member) {
  const std::vector<hsize_t> shape = in.group().shape(name);
  if (shape.size() != 3 || shape[0] != snapshots.size() || shape[2] != 3)
    throw std::runtime_error("HDF5 file has a wrong shape of " + name);
  const Eigen::Index columns = static_cast<Eigen::Index>(shape[1]);
  std::vector<double> all(snapshots.size() * shape[1] * 3);
  if (!all.empty()) in.group().read_block(name, all.data());
  for (std::size_t i = 0; i < snapshots.size(); ++i)
    snapshots[i].state.*member = Eigen::Map<const Points>(all.data() + i * shape[1] * 3, 3, columns);
}

/// Accelerations are there only if some snapshot knows them; then the others have what is not a number.
void stack_accelerations(const Writer& in, std::vector<Snapshot> snapshots) {
  const auto is_known = [](const Snapshot& snapshot) { return snapshot.state.a.size() > 0; };
  if (std::none_of(snapshots.begin(), snapshots.end(), is_known)) return;
  for (Snapshot& snapshot : snapshots)
    if (!is_known(snapshot))
      snapshot.state.a = Points::Constant(3, snapshot.state.q.cols(), std::numeric_limits<double>::quiet_NaN());
  stack(in, "a", "m/s2", snapshots, &State::a);
}

void stack_accelerations(const Reader& in, std::vector<Snapshot>& snapshots) {
  if (!in.group().has("a")) return;
  stack(in, "a", "m/s2", snapshots, &State::a);
  for (Snapshot& snapshot : snapshots)
    if (snapshot.state.a.hasNaN()) snapshot.state.a = {};
}

template <class Archive, class AnySnapshots>
void describe_snapshots(Archive in, AnySnapshots& snapshots) {
  std::vector<double> times, steps;
  for (const Snapshot& snapshot : snapshots) {
    times.push_back(snapshot.state.t);
    steps.push_back(snapshot.state.step);
  }
  in.field("stage", "", snapshots, &Snapshot::stage);
  in.field("sample", "", snapshots, &Snapshot::sample);
  in.list("t", "s", times);
  in.list("step", "s", steps);
  stack(in, "q", "m", snapshots, &State::q);
  stack(in, "v", "m/s", snapshots, &State::v);
  stack_accelerations(in, snapshots);
  if constexpr (std::is_same_v<Archive, Reader>) {
    if (times.size() != snapshots.size() || steps.size() != snapshots.size())
      throw std::runtime_error("HDF5 file has a wrong length of t or step");
    for (std::size_t i = 0; i < snapshots.size(); ++i)
      snapshots[i].state.t = times[i], snapshots[i].state.step = steps[i];
  }
}

template <class Archive, class AnyResults>
void describe(const Archive& in, AnyResults& results) {
  describe_report(in.group("report"), results);
  describe_scene(in.group("scene"), results.scene);
  describe_samples(in.group("samples"), results.samples);
  describe_snapshots(in.group("snapshots"), results.snapshots);
}

/// Lets `fill` write a file beside `path`, which takes its name when all of it is on disk.
void write_whole(const std::string& path, const std::function<void(const Group&)>& fill) {
  open_part(path);
  try {
    const hdf5::Quiet quiet;
    const Group root = Group::create_file(part_of(path));
    fill(root);
    root.flush();
  } catch (const std::runtime_error& error) {
    drop_part(path);
    throw std::runtime_error(path + ": " + error.what());
  } catch (...) {
    drop_part(path);
    throw;
  }
  rename_part(path);
}

}  // namespace

void write_hdf5(const Results& results, const std::string& path) {
  write_whole(path, [&](const Group& root) {
    root.set("format", std::string(results_format));
    describe(Writer(root.view()), results);
  });
}

Results read_hdf5(const std::string& path) {
  check_readable(path);
  try {
    const hdf5::Quiet quiet;
    const Group root = Group::open_file(path);
    std::string format;
    root.get("format", format);
    if (format != results_format) throw std::runtime_error("not " + std::string(results_format) + " but " + format);
    Results results;
    describe(Reader(root.view()), results);
    return results;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

void write_fabric_hdf5(const Fabric& fabric, const std::string& path) {
  write_whole(path, [&](const Group& root) {
    root.set("format", std::string(fabric_format));
    describe_fabric(Writer(root.create("fabric")), fabric);
  });
}

}  // namespace wale
