#include "studio/cli/export.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <numeric>

#include "sim/polyline.hpp"

namespace wale {
namespace {

constexpr int points_per_segment = 4;

/// Points on a yarn at even steps of the spline parameter, both ends included.
Points sample(const Fabric& fabric, const Yarn& yarn, const Points& q, int per_segment) {
  return polyline(fabric, q, yarn.first_segment, yarn.first_segment + yarn.segments - 1, per_segment);
}

template <class T>
void append(std::string& bytes, const T& value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof value);
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

}  // namespace

std::string to_obj(const Fabric& fabric, const Points& q) {
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  int next = 1;
  for (std::size_t i = 0; i < fabric.yarns.size(); ++i) {
    const Points samples = sample(fabric, fabric.yarns[i], q, points_per_segment);
    fmt::format_to(out, "o yarn_{}\n", i);
    for (const auto y : samples.colwise()) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", y.x(), y.y(), y.z());
    fmt::format_to(out, "l");
    for (int k = 0; k < samples.cols(); ++k) fmt::format_to(out, " {}", next++);
    fmt::format_to(out, "\n");
  }
  return fmt::to_string(text);
}

std::string to_bcc(const Fabric& fabric, const Points& q) {
  const auto count = [](std::uint64_t sum, const Yarn& yarn) {
    return sum + static_cast<std::uint64_t>(yarn.segments + 1);
  };
  std::string bytes =
      "BCC\x44"
      "C0\x03\x01";  // 4-byte integers and floats, Catmull-Rom, uniform, 3 dimensions, y up
  append(bytes, std::uint64_t{fabric.yarns.size()});
  append(bytes, std::accumulate(fabric.yarns.begin(), fabric.yarns.end(), std::uint64_t{0}, count));
  std::string info = "wale, metres";
  info.resize(40);
  bytes += info;
  for (const Yarn& yarn : fabric.yarns) {
    append(bytes, std::int32_t{yarn.segments + 1});
    const Points samples = sample(fabric, yarn, q, 1);
    for (const double coordinate : samples.reshaped()) append(bytes, static_cast<float>(coordinate));
  }
  return bytes;
}

}  // namespace wale
