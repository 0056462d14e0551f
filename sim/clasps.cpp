#include "sim/clasps.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "sim/net_crossing.hpp"
#include "sim/polyline.hpp"

namespace wale {

namespace {

constexpr int per_segment = 4;             // points of a polyline
constexpr double clasped_or_across = 0.5;  // of 2: from there up to what is surely clasped, links() decides
constexpr double centred = 1.5;            // of 2 crossings: where there are so many, the pieces need not be moved
constexpr int longest_look = 3;            // segments, to look past a count that stays equal
constexpr int most_cut_off = 2;            // segments, of each end of a piece

/// Yarn that may have slid from one state to the next, segments.
int reach(int first, int last) { return (last - first + 1) / 4; }

Points closed(const Points& line) {
  Points ring(3, line.cols() + 1);
  ring << line, line.col(0);
  return ring;
}

}  // namespace

Clasps::Clasps(const Fabric& fabric, const std::vector<Crossing>& crossings)
    : fabric_(fabric), crossings_(crossings), places_(crossings.size()) {}

/// Seen from anywhere, a side that is pulled through a loop crosses it twice in the same sense, unless an end of one
/// lies in front of the other; the mean over all views, twice Gauss's linking integral of the two pieces, is near 2 for
/// a clasp and near 0 for a side pushed out of its loop.
double Clasps::count(const Crossing& of, const Place& at, const Points& q) const {
  const Points loop = polyline(fabric_, q, of.loop_first + at.loop, of.loop_last + at.loop, per_segment);
  const Points side = polyline(fabric_, q, of.side_first + at.side, of.side_last + at.side, per_segment);
  return of.sign * mean_net_crossing(side, loop);
}

/// A loop that gave yarn to others is shorter than the pieces, whose ends then cross back: a clasp counts down to 1, as
/// yarn does that only lies across. These are told apart by whether the side goes through the loop closed by its chord,
/// or links with it once closed itself, without those ends.
bool Clasps::links(const Crossing& of, const Place& at, const Points& q) const {
  const int shorter = std::min(of.side_last - of.side_first, of.loop_last - of.loop_first);
  for (int cut = 0; cut <= most_cut_off && 2 * cut < shorter; ++cut) {
    const auto piece = [&](int first, int last) { return polyline(fabric_, q, first + cut, last - cut, per_segment); };
    const Points loop = closed(piece(of.loop_first + at.loop, of.loop_last + at.loop));
    const Points side = piece(of.side_first + at.side, of.side_last + at.side);
    if (of.sign * mean_net_crossing(side, loop) >= surely_clasped) return true;
    if (of.sign * mean_net_crossing(closed(side), loop) >= surely_clasped) return true;
  }
  return false;
}

bool Clasps::within_yarn(const Crossing& of, const Place& at) const {
  const auto on_one_yarn = [this](int first, int last) {
    return first >= 0 && last < fabric_.segment_count() && fabric_.segment(first).yarn == fabric_.segment(last).yarn;
  };
  return on_one_yarn(of.side_first + at.side, of.side_last + at.side) &&
         on_one_yarn(of.loop_first + at.loop, of.loop_last + at.loop);
}

/// Along both yarns while the count rises; gives the count there. The next clasp, a whole loop away, is out of reach,
/// and of the opposite sense.
double Clasps::climb(const Crossing& of, Place& best, const Points& q) const {
  const int side_reach = reach(of.side_first, of.side_last), loop_reach = reach(of.loop_first, of.loop_last);
  const Place from = best;
  double most = count(of, best, q);
  const auto higher = [&](int by_side, int by_loop) {
    const Place next{best.side + by_side, best.loop + by_loop};
    if (std::abs(next.side - from.side) > side_reach || std::abs(next.loop - from.loop) > loop_reach) return false;
    if (!within_yarn(of, next)) return false;
    const double there = count(of, next, q);
    if (there <= most) return false;
    most = there;
    best = next;
    return true;
  };
  for (int step = 1; most < centred && step <= longest_look; ++step)
    if (higher(step, 0) || higher(-step, 0) || higher(0, step) || higher(0, -step)) step = 0;
  return most;
}

bool crosses_twice(const Fabric& fabric, const Crossing& of, const Points& q, const Vec3& along) {
  const Points loop = polyline(fabric, q, of.loop_first, of.loop_last, per_segment);
  return net_crossing(polyline(fabric, q, of.side_first, of.side_last, per_segment), loop, along) == 2 * of.sign;
}

std::vector<bool> Clasps::follow(const Points& q) {
  std::vector<std::uint8_t> held(crossings_.size());  // threads cannot share the words of vector<bool>
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    const double counted = climb(crossings_[i], places_[i], q);
    held[i] = counted >= surely_clasped || (counted >= clasped_or_across && links(crossings_[i], places_[i], q));
  }
  return {held.begin(), held.end()};
}

}  // namespace wale
