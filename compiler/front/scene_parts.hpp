/// The parts of a scene file that have a reader of their own.
#pragma once

#include <optional>
#include <vector>

#include "compiler/front/scene.hpp"
#include "compiler/yaml.hpp"
#include "sim/scene.hpp"

namespace wale {

/// `fabric`: the pattern, and what is asked of it.
void read_fabric(const YamlNode&, ParsedScene&, Diagnostics&);
/// Adds what `node` names to the stage's effects; one that is there already is replaced. `auto`, alone or among them,
/// adds those that may matter, and leaves the choice open. Of a periodic fabric those are refused that act on ends or
/// need something to hold it.
void read_effects(const YamlNode& node, bool periodic, Stage&, Mentions&, Diagnostics&);
/// `obstacle`: one body, or a list of them; at least one.
std::vector<EffectSpec> read_obstacles(const YamlNode&, Mentions&, Diagnostics&);
/// `shrink`: which yarn by how much, or a list of that.
std::vector<Shrink> read_shrink(const YamlNode&, Mentions&, Diagnostics&);
/// `quasi_static`, `runge_kutta` or `implicit`, alone or as a map with settings. Of a periodic fabric nothing sleeps.
SolverSpec read_solver(const YamlNode&, bool periodic, Diagnostics&);
/// `pull`: a direction and a strain, or several. Nothing if it is no map.
std::optional<Pull> read_pull(const YamlNode&, bool periodic, Diagnostics&);
/// `deform`: what becomes of both periods, their shear and their curl.
Deform read_deform(const YamlNode&, Diagnostics&);
/// `common` holds the effects and the solver of every stage.
std::vector<Stage> read_stages(const YamlNode& root, const Stage& common, bool periodic, bool curls, Mentions&,
                               Diagnostics&);

}  // namespace wale
