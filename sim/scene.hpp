/// What a scene may call for, on one page: effects, solvers, stages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/fabric.hpp"
#include "sim/schedule.hpp"

namespace wale {

/// V = ½ EA l ∫ (|y'|/l - 1)² ds (Ding et al. 2023, Eq. 12).
struct Stretch {
  int nodes = 1;  ///< Gauss nodes a segment: 1 avoids membrane locking, 3 is the paper's exact integral
};
/// What a yarn is bent like where no bending moment acts on it.
enum class RestShape : std::uint8_t {
  straight,  ///< κ_0 = 0
  as_laid    ///< it has set: κ_0 is the curvature as laid by the compiler, times l0 / l as its rest length shrinks
};
/// V = ½ EI l ∫ (κ - κ_0)² ds (Eqs. 13, 14, with a rest curvature). How strongly a yarn bends is remembered, not
/// towards which side: turning its bends about the yarn (torsion) costs nothing.
struct Bend {
  int nodes = 3;  ///< Gauss nodes a segment
  RestShape rest = RestShape::straight;
};
/// Where in a fabric an effect acts: everywhere, unless it is narrowed.
struct Part {
  std::vector<int> materials{};  ///< of some yarns, places in Fabric::materials; empty: of all
  std::vector<int> segments{};   ///< of those only these; empty: all
};
/// V = -rho l0 ∫ y·g ds (Eq. 15, sign corrected).
struct Gravity {
  Vec3 acceleration{0, -9.81, 0};  ///< g, m/s²
  Part on{};
};
/// D = k_g l ∫ |v|² ds (Eq. 16, with the factor l).
struct Drag {
  double coefficient = 0.02;  ///< k_g, kg/(m s)
  Part on{};
};
/// Yarns push each other apart; law, stiffness and diameter are the material's (Eqs. 17-20).
struct Contact {
  double sampling = 0.03;      ///< α of Eq. (A.5): sets the number of beads a segment
  double screening = 1.6;      ///< β: beads of one yarn nearer along it than β d do not touch
  bool inflate_beads = false;  ///< the paper's option: d_con of Eq. (A.4) in the sum instead of d
  double skin = 0.1;           ///< over the diameter: how far beyond touching near segments are listed; no answer's
};
/// Viscous damping where yarns touch (Eqs. 19, 21); not friction.
struct ContactDamping {
  double tangential = 0;  ///< k_dt, N s/m³
  double normal = 0;      ///< k_dn, N s/m³
  double sampling = 0.03, screening = 1.6, skin = 0.1;
};
/// Coulomb friction of yarn on yarn: up to µ times the normal force of the contact law, against the motion that is left
/// when that along the normal is taken out. It is smoothed: below the threshold two yarns that stick creep.
struct Friction {
  double coefficient = 0.3;  ///< µ
  double threshold = 1e-5;   ///< m/s, the sliding speed from which friction is µ N
  double sampling = 0.03, screening = 1.6, skin = 0.1;
};
/// V = k_t l0 ∫ |W (y - F(y_ref, t))|² ds over some segments (Eq. A.6); y_ref is where the stage begins.
/// F scales about `centre` and moves: F(y, t) = centre + S (y - centre) + u, S = 1 + p(t) (scale - 1), u = p(t) move.
struct Tether {
  std::string label = "tether";
  std::vector<int> segments;
  double stiffness = 1e6;   ///< k_t, N/m²
  Vec3 axes{1, 1, 1};       ///< W: 1 holds along that axis, 0 leaves it free
  Vec3 centre{0, 0, 0};     ///< m
  Vec3 scale{1, 1, 1};      ///< at p = 1
  Vec3 move{0, 0, 0};       ///< at p = 1, m
  Schedule progress = 0.0;  ///< p(t)
};
/// Two smooth plates a distance apart keep a swatch flat, as one lays it on a table:
/// V = k_p l0 ∫ max(0, |z| - gap/2)² ds.
struct Plates {
  double stiffness = 1e4;  ///< k_p, N/m²
  double gap = 2e-3;       ///< m, between the planes that the yarn axes may not pass
};

/// A rigid, smooth body that yarns cannot enter: V = k_o l0 ∫ max(0, d/2 - gap)² ds, with the distance `gap` of the
/// yarn axis from its surface and the contact diameter d. Pressed by f a length, a yarn sinks in by f / (2 k_o).
struct Obstacle {
  enum class Shape : std::uint8_t { plane, cylinder, sphere };
  std::string label = "obstacle";
  Shape shape = Shape::plane;
  Vec3 centre{0, 0, 0};     ///< at p = 0; of a plane any point, of a cylinder any point of its axis, m
  Vec3 axis{0, 0, 1};       ///< of length 1: a plane's normal, towards the yarns; a cylinder's axis; no sphere's
  double radius = 0;        ///< m; no plane's
  double stiffness = 1e6;   ///< k_o, N/m²
  Vec3 move{0, 0, 0};       ///< by which the centre has moved at p = 1, m
  Schedule progress = 0.0;  ///< p(t)
  Part on{};
};
/// What blows a tube up: V = -p h A. A is the area that the yarns enclose as seen along the tube's axis, all their
/// turns together, and h the height of one turn, so that h A is the tube's volume. Positive blows it up.
struct Pressure {
  double from = 0, to = 0;  ///< p where `progress` is 0 and 1, Pa
  Vec3 axis{0, 1, 0};       ///< of length 1
  double spacing = 0;  ///< h, m; 0: as the yarns lie where the stage begins, their extent along the axis over their
                       ///< turns about it
  Schedule progress = 1.0;
};
/// A yarn that is twisted and cannot turn about itself at its ends bears a torque M along it: V = -2π M (Wr - Wr_0),
/// with the writhe Wr of its axis, and Wr_0 that where the stage begins. Positive is the torque of right-handed (Z)
/// twist.
struct Twist {
  double from = 0, to = 0;  ///< M where `progress` is 0 and 1, N m
  Schedule progress = 1.0;
  std::vector<int> materials{};  ///< see Gravity
};

/// A point of one segment tied to a point of another.
struct Knot {
  int segment_a = 0, segment_b = 0;
  double s_a = 0, s_b = 0;  ///< spline parameter in the segment, [0, 1]
  double length = 0;        ///< m between the two yarn axes
};
/// V = Σ k (|y_a - y_b| - length)²: loose yarn ends tied to the stitch beside them, as a knitter secures them;
/// without friction they would creep out. `compile` fills in the knots.
struct Knots {
  std::vector<Knot> knots;
  double stiffness = 100;  ///< k, N/m
};

using EffectSpec = std::variant<Stretch, Bend, Gravity, Drag, Contact, ContactDamping, Friction, Tether, Plates,
                                Obstacle, Pressure, Twist, Knots>;

/// Explicit Runge-Kutta methods with an embedded error estimate, adaptive (Hairer, Nørsett & Wanner I, II.4, II.5).
struct RungeKutta {
  enum class Method : std::uint8_t {
    kutta,          ///< 4(3), Ding et al. 2023, A.1: longer steps where stability bounds them
    dormand_prince  ///< 5(4): fewer evaluations where accuracy does
  };
  Method method = Method::kutta;
  double relative = 1e-4;  ///< error per step over the size of the state
  double absolute = 1e-8;  ///< m, and m/s for velocities
  double first_step = 0;   ///< s; 0: Hairer's choice
  double sleep = 0;  ///< most force on a part that is held still as at rest, over EI/d²; 0: none is; see Sleepers
};
/// Motion by TR-BDF2 (Bank et al. 1985), implicit, L-stable and of order two, with steps by its error (Hosea & Shampine
/// 1996): stiff motion that has died away does not bound the step.
struct Implicit {
  double relative = 1e-2;        ///< error a step: of velocities over the speed, of positions over the way gone
  double absolute = 1e-7;        ///< m, an error of positions that is always small enough
  double absolute_speed = 1e-4;  ///< m/s, one of velocities
  double first_step = 0;         ///< s; 0: by the acceleration at the start
  int iterations = 30;           ///< of Newton's method; a step that needs more is halved
};
/// Equilibrium after equilibrium, by a trust-region Newton method on the energy.
struct QuasiStatic {
  double tolerance = 0.02;      ///< largest residual force on a control point, over the yarn's bending force EI/d²
  double of_load = 0.01;        ///< in a pull also over the load on one wale or course, as far down as `tolerance`/20
  int iterations = 200;         ///< a load step that needs more is halved
  double first_step = 0;        ///< share of the stage; 0: from sample to sample
  double smallest_step = 1e-3;  ///< share of the stage: below this the solve has failed
};
using SolverSpec = std::variant<QuasiStatic, RungeKutta, Implicit>;

enum class Along : std::uint8_t { wale, course };

/// Pull the two ends apart, or lengthen a period, to engineering strains, one after the other; see strain_of().
struct Pull {
  Along along = Along::wale;
  std::vector<double> strains{0.6};  ///< 0.6 is 60 %; at least one, the first other than 0, each other than the last
};

/// What becomes of the two periods of a periodic fabric. Strains are engineering strains, counted from the periods with
/// which the stage begins.
struct Deform {
  enum class How : std::uint8_t { free, held, driven };
  struct Part {
    How how = How::free;
    std::vector<double> strains{};  ///< of a part that is driven, reached one after the other: at least one, and as
                                    ///< many in each such part; each moves one of them on; see strain_of()
    bool operator==(const Part&) const = default;
  };
  Part wale{};    ///< the length of the wale period along the wales
  Part course{};  ///< the length of the course period
  Part shear{};   ///< how far the wale period leans along the courses, over its length along the wales
  Part curl{};    ///< of a fabric that may curl, its curvature itself in place of strains, 1/m
  /// Whether both periods come to the lengths that they like.
  bool leaves_periods_free() const {
    const auto free = [](const Part& part) { return part.how == How::free; };
    return free(wale) && free(course) && free(shear);
  }
  bool operator==(const Deform&) const = default;
};

enum class Hold : std::uint8_t { none, ends, periods };

/// What yarn loses of its rest length, as one that is heated or that acts by itself.
struct Shrink {
  std::vector<int> materials{};  ///< places in Fabric::materials; empty: all yarns
  double by = 0;                 ///< share of the length that the tightening leaves, at the end of the stage; negative:
                                 ///< it grows
};

struct Stage {
  std::string name = "run";         ///< "tighten", "relax", "pull": in results and messages
  double duration = 1;              ///< s; quasi-static: the load parameter's range
  int samples = 10;                 ///< snapshots at even intervals, the last one at the end
  std::optional<double> tighten;    ///< rest lengths go to this share of the way from `length` to `knitted`
  std::vector<Shrink> shrink;       ///< each yarn by the last that names it; the others stay as shrunk as they were
  Hold hold = Hold::none;           ///< `ends`: cast-on and bind-off are held and shrink with the rest length;
                                    ///< `periods`: those of a periodic fabric are held
  std::optional<Along> mount;       ///< grips close and move apart until they read no force; a sample a move
  std::optional<Pull> pull;         ///< not with `deform`
  std::optional<Deform> deform;     ///< of a periodic fabric; see deform_of()
  double grip_stiffness = 1e6;      ///< k_t of the tethers of `hold` and `pull`, N/m²
  std::vector<EffectSpec> effects;  ///< what is not here is not simulated
  SolverSpec solver;
  bool effects_open = false;  ///< of `effects`, those that cannot matter are to be left out before it runs
  bool solver_open = false;   ///< nobody asked for this solver

  /// A repeat that is kept flat, or tightened at given periods, relaxes.
  bool strains() const {
    const bool relaxes =
        deform && (tighten || (deform->leaves_periods_free() && deform->curl.how != Deform::How::driven));
    return pull || (deform && !relaxes);
  }
  bool follows_motion() const { return !std::holds_alternative<QuasiStatic>(solver); }
  /// Then the fabric does not lie as it relaxed.
  bool grips() const { return mount || strains(); }
};

/// How the fabric is measured: the two ends that are gripped, along either direction (a periodic fabric has none), and
/// its reference section.
struct Gauge {
  std::array<std::vector<int>, 2> wale_ends;    ///< segments of the bottom and the top grip
  std::array<std::vector<int>, 2> course_ends;  ///< segments of the left and the right grip
  int wales = 0, courses = 0;                   ///< of the swatch, or of the repeat
  double thickness = 0;                         ///< 2r of sigma = F / (2r S_R), m
};

/// One yarn end held by a linear constraint; used by rod problems, not by swatches.
struct Clamp {
  int yarn = 0;
  bool at_end = false;     ///< false: the yarn's start, true: its end
  bool position = true;    ///< hold y
  bool direction = false;  ///< hold the direction of y' (its length stays free)
};

/// One side of a loop, from its head to the head beside it, that the stitch graph demands to be pulled through another
/// loop; as segment ranges [first, last] of the fabric or, if that is periodic, of its tile() of repeats_for_crossings
/// each way. See sim/results/topology.hpp and sim/tile.hpp.
struct Crossing {
  int side_first = 0, side_last = 0;
  int loop_first = 0, loop_last = 0;
  int sign = 0;  ///< of the two crossings that the side makes with the loop, as net_crossing() counts them
  bool operator==(const Crossing&) const = default;
};

struct Scene {
  std::string name;
  std::optional<double> accuracy;  ///< of the stress over its peak: settings are to be chosen for it before it runs
  Fabric fabric;
  std::vector<Stage> stages;
  Gauge gauge;
  std::vector<Clamp> clamps;
  std::vector<Crossing> crossings;
};

}  // namespace wale
