/// Reads the settings of one effect or solver of a scene.
#pragma once

#include <fmt/format.h>

#include "compiler/fields.hpp"
#include "compiler/front/scene.hpp"

namespace wale {

/// "5-20", reported if it is something else; nothing of a null.
std::optional<IntRange> read_range(const YamlNode*, Diagnostics&);

/// `key:` with nothing behind it keeps every default. What is read replaces the value that is there. `node` must
/// outlive it.
class Settings {
 public:
  Settings(const YamlNode& node, std::string_view what, std::vector<std::string_view> known, Diagnostics& say)
      : node_(node), what_(what), say_(say) {
    if (node.kind != YamlNode::Kind::null) Fields(node, what, std::move(known), say);
  }

  /// Reports an absent key; `hint` shows how to give it.
  void require(std::string_view key, std::string hint) const;
  void count(std::string_view key, int least, int most, int& value) const;
  void quantity(std::string_view key, const Dimension& dimension, Range range, double& value) const;
  void flag(std::string_view key, bool& value) const;
  /// Three components; `noun` is "an acceleration", `hint` shows how to write them.
  void vector(std::string_view key, std::string_view noun, const Dimension&, Range, std::string hint,
              Vec3& value) const;
  /// One yarn's name, or a list of them, as places in Mentions::yarns.
  void yarns(std::string_view key, Mentions& mentions, std::vector<int>& value) const;
  /// Yarns as above, or a map: `yarns`, `courses`, `wales` of a chart, `needles` of a knitout file. A region is a place
  /// in Mentions::regions, as the only one of Part::segments.
  void part(std::string_view key, Mentions& mentions, Part& value) const;
  const YamlNode* find(std::string_view key) const { return node_.find(key); }

 private:
  const YamlNode& node_;
  std::string what_;
  Diagnostics& say_;
};

}  // namespace wale
