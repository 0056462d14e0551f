/// Which material each yarn is of: yarns of a chart by name, those of a machine's program by carrier.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/diagnostic.hpp"
#include "compiler/program.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// What a scene says.
struct YarnMaterials {
  struct Named {
    std::string yarn;  ///< or carrier
    Material material;
    Span span;  ///< of the name
  };
  std::optional<Material> otherwise;  ///< for yarns that are not named; nothing: as the pattern has it
  std::vector<Named> by_name;
};

/// What the carriers of a program are assumed to hold, by carrier: the known material that a header names
/// (`;;Yarn-5: acrylic_16_2, rust`), else the default.
std::vector<Material> default_materials(const Program&);

/// The materials of `yarns`, in their order: as given by name, else for all, else as `assumed`. An error at each name
/// that is not among them; `kind` is what messages call them: "yarn" or "carrier".
std::vector<Material> materials_of(const std::vector<std::string>& yarns, const YarnMaterials& given,
                                   std::vector<Material> assumed, std::string_view kind, Diagnostics&);

}  // namespace wale
