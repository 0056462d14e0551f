/// A scene file, read: which chart, changed how, and what is done to its fabric.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/chart.hpp"
#include "compiler/diagnostic.hpp"
#include "compiler/knitout_options.hpp"
#include "sim/scene.hpp"

namespace wale {

/// A key of `fabric` that patterns of one kind take and the others do not.
struct PatternKey {
  bool knitout = false;   ///< for knitout files; else for charts
  std::string_view what;  ///< "`crop`"
  std::string_view hint;  ///< what to write instead where the pattern is of the other kind
  Span span;              ///< of its value
};

/// What effects and stages ask of a pattern, in the order read; it can be checked when that is known.
struct Mentions {
  struct Yarn {
    std::string name;  ///< of a chart's yarn, or of a carrier
    Span span;
  };
  /// Counted as a crop of the same kind of pattern is.
  struct Region {
    std::optional<IntRange> courses, wales, needles;
    Span span;
  };
  std::vector<Yarn> yarns;  ///< until the pattern is known, the `materials` of an effect or a stage are places in it
  std::vector<Region> regions;  ///< likewise the only one of the `segments` of an effect
  std::vector<Span> tubes;      ///< effects that need a tube
};

/// A Scene less its fabric.
struct ParsedScene {
  std::string name;
  std::string pattern_path;  ///< of the chart or knitout file, resolved against the scene file's folder
  Span pattern_span;
  ChartOverrides overrides;              ///< of a chart; its materials are for the carriers of a knitout file too
  KnitoutOptions knitout;                ///< of a knitout file
  std::vector<PatternKey> pattern_keys;  ///< those given, in the order read
  Curls curls = Curls::never;            ///< of a periodic fabric
  int segments_per_stitch = 12;
  std::optional<double> accuracy;  ///< see Scene
  double thickness = 0;            ///< 2r of sigma = F / (2r S_R), m; 0: twice the contact diameter
  std::vector<Stage> stages;
  Mentions mentions;
};

/// An accuracy as a scene or a command line gives it: "1 %". Nothing if an error was reported.
std::optional<double> read_accuracy(std::string_view text, Span, Diagnostics&);

/// Nothing if an error was reported.
std::optional<ParsedScene> parse_scene(const Source&, Diagnostics&);

/// Whether the scene asks only for what its pattern, a knitout file or a chart, can give; an error at each key that
/// does not suit it.
bool suits(const ParsedScene&, bool knitout, Diagnostics&);

/// The text of the scene's chart. Null, with a report at the place that names it, if it cannot be read.
const Source* read_pattern(const ParsedScene&, Sources&, Diagnostics&);

}  // namespace wale
