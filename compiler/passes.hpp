/// The compiler's table of contents: every pass, in the order they run.
#pragma once

#include <optional>

#include "compiler/arrangement.hpp"
#include "compiler/chart.hpp"
#include "compiler/crop.hpp"
#include "compiler/curves.hpp"
#include "compiler/diagnostic.hpp"
#include "compiler/machines.hpp"
#include "compiler/passes/loop_shape.hpp"
#include "compiler/program.hpp"
#include "compiler/repeat.hpp"
#include "compiler/stitch_graph.hpp"
#include "compiler/stitch_lengths.hpp"
#include "sim/scene.hpp"

namespace wale::passes {

/// How a chart's first and last course are secured: by a spiral, or not at all, as a knitout file's always are.
struct Edges {
  bool cast_on = false, bind_off = false;
  int yarns = 0;  ///< materials; after them follow their edge forms
};

/// One repeat of a periodic fabric, continued to all sides by so much that it lies as it would in an endless one.
struct Continued {
  Chart chart;
  Repeat repeat;
};

std::optional<Chart> parse_chart(const Source&, const ChartOverrides&, Diagnostics&);
/// Of a periodic chart: the larger piece in which its repeat is drawn. An error if it cannot be continued, as a tube or
/// a course of several yarns.
std::optional<Continued> continue_chart(const Chart&, Diagnostics&);
/// A knitout file. Always gives a program: lines at fault are reported and left out, so that the rest can be counted.
Program parse_knitout(const Source&, Diagnostics&);
/// How much yarn each loop takes, by the stitch setting under which it is made.
void set_stitch_lengths(Program&, const StitchLengths&);
/// Knit on the front bed, purl on the back bed, transfers between; a tube goes round both beds at half gauge.
/// Every instruction carries the span and the place of its chart cell.
std::optional<Program> lower_chart(const Chart&, Diagnostics&);
/// The same for a real machine: cast-on, bind-off by transfers, carriers by the machine's names, headers.
std::optional<Program> machine_program(const Chart&, const Target&, Diagnostics&);
/// What a machine would refuse: carriers, racking, needles.
void check_program(const Program&, Diagnostics&);
/// Runs the needle beds; stops at the first thing that a machine cannot do.
std::optional<StitchGraph> knit(const Program&, Diagnostics&);
/// The same, but does as much of a faulty instruction as makes sense, without a word: what check_program has told of
/// can still be counted.
StitchGraph knit_all(const Program&);
/// The part that is wanted. Where it is cut off above, loops stay on the needles, as if knitting had stopped there.
StitchGraph crop(const StitchGraph&, const Crop&);
/// Loops that hold nothing, what would unravel.
void check_graph(const StitchGraph&, Diagnostics&);
/// What a machine does with its own program, and a knitter would regret: loops left on needles, dropped columns.
void check_knitting(const Program&, const StitchGraph&, Diagnostics&);
/// Loops made of nothing and let go of before anything was pulled through them, as those that hold an inlay until the
/// next row is knitted, are no loops any more: the yarn only passes there.
StitchGraph let_run(const StitchGraph&);
/// A chart is one piece of yarn: where its yarns change, the end of one is tied to the next. Loops keep their carriers.
StitchGraph tie_ends(const StitchGraph&);
/// Where loops hang from each other.
Arrangement arrange(const StitchGraph&, const LoopSize&, double diameter);
/// One smooth curve a yarn, through the right side of each loop. `edges` are for graphs of charts.
Curves draw(const StitchGraph&, const Arrangement&, const LoopSize&, double diameter, const Edges& edges);
/// Of a periodic chart: each course of the repeat, from its first stitch to the same one a repeat further, out of the
/// curves of the larger piece. The first stitch of the lowest course begins at the origin.
Curves cut_repeat(const Curves&, const StitchGraph&, const Repeat&);
/// Equal arc length, spline through the points; `segments_per_stitch` at least 8. Pieces count `yarns`, and after them
/// their edge forms in the same order; the fabric has those of which there is a piece. Curves with a cell become a
/// periodic fabric.
Fabric fit(const Curves&, const std::vector<Material>& yarns, int segments_per_stitch);
/// Whether the fabric has every crossing that its graph demands, and no yarn through a loop that it does not; an error
/// at the first loop that is not placed right.
void prove(const StitchGraph&, const Fabric&, const std::vector<Crossing>&, Diagnostics&);
/// The first half of it, for crossings of a part of the graph.
void prove_crossings(const StitchGraph&, const Fabric&, const std::vector<Crossing>&, Diagnostics&);
}  // namespace wale::passes
