#include "sim/results/vtk_file.hpp"

#include <fmt/format.h>

#include <bit>

namespace wale {

void VtkFile::add(const std::string& section, const std::string& name, const std::vector<float>& values,
                  int components) {
  append(section, name, "Float32", components, values.data(), values.size() * sizeof(float));
}

void VtkFile::add(const std::string& section, const std::string& name, const std::vector<std::int32_t>& values) {
  append(section, name, "Int32", 1, values.data(), values.size() * sizeof(std::int32_t));
}

/// Each block of appended bytes follows its size in 8 bytes; an array says where its block begins.
void VtkFile::append(const std::string& section, const std::string& name, const char* type, int components,
                     const void* bytes, std::size_t size) {
  arrays_.push_back({section, fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                                          "format=\"appended\" offset=\"{}\"/>\n",
                                          type, name, components, appended_.size())});
  const std::uint64_t header = size;
  appended_.append(reinterpret_cast<const char*>(&header), sizeof header);
  appended_.append(static_cast<const char*>(bytes), size);
}

std::string VtkFile::finish(std::size_t points, std::size_t lines, std::size_t polys, const std::string& active) const {
  std::string file = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", points, lines, polys);
  for (const std::string section : {"Points", "Lines", "Polys", "PointData", "CellData"}) {
    std::string tags;
    for (const Array& array : arrays_)
      if (array.section == section) tags += array.tag;
    if (tags.empty()) continue;
    const std::string with = section == "PointData" ? fmt::format(" Scalars=\"{}\"", active) : "";
    file += fmt::format("<{0}{1}>\n{2}</{0}>\n", section, with, tags);
  }
  file += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  return file + appended_ + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace wale
