#include "studio/cli/yarn_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "sim/results/file.hpp"
#include "sim/results/hdf5.hpp"
#include "sim/results/picture.hpp"
#include "sim/results/vtk.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/export.hpp"

namespace wale {
namespace {

std::string suffix_of(const std::string& path) { return std::filesystem::path(path).extension().string(); }

}  // namespace

bool can_write_yarns(const std::string& path) {
  constexpr std::array known{".h5", ".vtp", ".obj", ".bcc", ".svg"};
  const std::string suffix = suffix_of(path);
  if (std::find(known.begin(), known.end(), suffix) != known.end()) return true;
  return complain(path, "the suffix is none that can be written", "write .h5, .vtp, .obj, .bcc, .svg or .k"), false;
}

void write_yarns(const Compiled& compiled, const std::string& path) {
  const Fabric& fabric = compiled.fabric;
  const std::string suffix = suffix_of(path);
  if (suffix == ".h5") write_fabric_hdf5(fabric, path);
  if (suffix == ".vtp") write_vtp(fabric, fabric.points, path, {});
  if (suffix == ".obj") write_file(path, to_obj(fabric, fabric.points));
  if (suffix == ".bcc") write_file(path, to_bcc(fabric, fabric.points));
  if (suffix == ".svg")
    write_file(path, fabric_svg(fabric, fabric.points, {compiled.name, ColourBy::material, 0, {}, 900}));
}

}  // namespace wale
