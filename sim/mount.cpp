#include "sim/mount.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wale {
namespace {

constexpr double furthest_step = 0.02;  // of the gauge length
constexpr double first_step = 0.001;    // of the gauge length, while the stiffness is unknown

/// The latest attempt of those that pull (or push).
std::optional<Mounted> latest(const std::vector<Mounted>& tried, bool pulls) {
  const auto found =
      std::find_if(tried.rbegin(), tried.rend(), [&](const Mounted& each) { return (each.force > 0) == pulls; });
  return found == tried.rend() ? std::nullopt : std::optional(*found);
}

double secant(const Mounted& a, const Mounted& b) {
  return b.travel - b.force * (b.travel - a.travel) / (b.force - a.force);
}

}  // namespace

double next_travel(const std::vector<Mounted>& tried, double gauge_length, double unread) {
  if (tried.empty()) return 0;
  const Mounted& now = tried.back();
  if (std::abs(now.force) <= unread) return now.travel;
  const double apart = now.force > 0 ? -1 : 1;
  const std::optional<Mounted> pull = latest(tried, true), push = latest(tried, false);
  // A fabric that yields while it settles may push where it pulled before; then the older attempt tells nothing.
  if (pull && push && pull->travel > push->travel) return secant(*push, *pull);
  double step = first_step * gauge_length;
  if (tried.size() > 1) {
    const Mounted& before = tried[tried.size() - 2];
    const double ahead = (secant(before, now) - now.travel) * apart;
    step = std::isfinite(ahead) && ahead > 0 ? ahead : 2 * step;
  }
  return now.travel + apart * std::min(step, furthest_step * gauge_length);
}

}  // namespace wale
