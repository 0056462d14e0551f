/// The XML of a VTK PolyData file with its numbers appended as raw bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wale {

/// Gathers arrays and puts them together. Sections are "Points", "PointData", "CellData", "Lines", "Polys".
class VtkFile {
 public:
  void add(const std::string& section, const std::string& name, const std::vector<float>& values, int components = 1);
  void add(const std::string& section, const std::string& name, const std::vector<std::int32_t>& values);
  /// The whole file; `active` names the point data to colour by at first.
  std::string finish(std::size_t points, std::size_t lines, std::size_t polys, const std::string& active) const;

 private:
  struct Array {
    std::string section, tag;
  };
  void append(const std::string& section, const std::string& name, const char* type, int components, const void* bytes,
              std::size_t size);

  std::vector<Array> arrays_;
  std::string appended_;
};

}  // namespace wale
