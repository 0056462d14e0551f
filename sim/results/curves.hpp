/// What is read off a run: the stress-strain curve, its features, and the sizes of a state.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/results/results.hpp"

namespace wale {

/// One entry a sample, in the order pulled. A number that the table lacks is NaN.
struct Curve {
  std::vector<double> strain;          ///< engineering strain, 0.6 is 60 %
  std::vector<double> stress;          ///< Pa
  std::vector<double> force;           ///< N
  std::vector<double> force_per_wale;  ///< N
};

struct LabelledCurve {
  std::string label;
  Curve curve;
};

/// Rows of the table that belong to the curve: those of the last stage that pulls or deforms, so that it has a `strain`
/// or a `strain.*`.
std::vector<std::size_t> strained_rows(const Table&);

/// Of strained_rows(), the last of those with the greatest strain; of a stage that deforms, of the three strains' root
/// of squares. Nothing if there are none.
std::optional<std::size_t> most_strained_row(const Table&);

/// The columns `strain`, `stress`, `force` and `force_per_wale` of strained_rows(); nothing of a stage that deforms.
Curve stress_strain(const Results&);

/// The same without a label; of a stage that deforms `strain.wale` and `stress.wale`, and likewise course and shear.
std::vector<LabelledCurve> stress_strain_curves(const Results&);

/// The three numbers that sum up a J-shaped curve; NaN where the curve is too short to say.
struct Features {
  double initial_stiffness = 0;  ///< Pa: slope of the line fitted to the first part
  double transition_strain = 0;  ///< where the two fitted lines cross; NaN unless that is within the curve
  double final_stiffness = 0;    ///< Pa: slope of the line fitted to the last part
};

/// Of a pull to and fro, the way to the first turning point is looked at. Both lines are least-squares fits of stress
/// over strain: the first up to 0.10 beyond the first strain, the last from 0.10 before the last. On a curve shorter
/// than 0.30 a part is a third of it. A part with fewer than two samples takes in the nearest ones. Samples without a
/// stress are left out.
Features features(const Curve&);

/// Sizes of a fabric in the state `q`, m.
///
/// Wale-wise is the direction between the mean positions of the wale grips, course-wise that between the course
/// grips. Each stitch counts as one point, the mean of its yarn. On a regular grid of n rows the rows' positions
/// have the standard deviation a sqrt((n² - 1)/12) at spacing a; solved for a, this gives the two spacings. It asks
/// only how many courses and wales there are, not which stitch belongs where, and a lost edge loop moves it little.
/// A tube has no course grips: its wale spacing is the mean distance, less the part along the wales, of stitches
/// that follow each other on a yarn.
/// Length and width are spacing times count: the field of loops, without cast-on and bind-off.
/// Thickness is the span between the 5th and 95th percentile of the yarns' axes across the fabric (along z for a
/// tube), plus the greatest diameter.
/// Sizes that cannot be told (no grips, no stitches, a single course or wale) are 0.
Sizes measure(const Fabric&, const Gauge&, const Points& q);

}  // namespace wale
