#include "studio/cli/export.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <numeric>
#include <vector>

#include "sim/spline.hpp"

namespace wale {
namespace {

constexpr int points_per_segment = 4;

/// Points on a yarn at even steps of the spline parameter, both ends included.
std::vector<Vec3> sample(const Fabric& fabric, const Yarn& yarn, const Points& q, int per_segment) {
  std::vector<Vec3> samples;
  for (int segment = 0; segment < yarn.segments; ++segment) {
    for (int k = 0; k < per_segment; ++k) {
      samples.push_back(
          combine(q, fabric.first_point(yarn.first_segment + segment), basis(double(k) / per_segment).value));
    }
  }
  samples.push_back(combine(q, fabric.first_point(yarn.first_segment + yarn.segments - 1), basis(1).value));
  return samples;
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
    const std::vector<Vec3> samples = sample(fabric, fabric.yarns[i], q, points_per_segment);
    fmt::format_to(out, "o yarn_{}\n", i);
    for (const Vec3& y : samples) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", y.x(), y.y(), y.z());
    fmt::format_to(out, "l");
    for (std::size_t k = 0; k < samples.size(); ++k) fmt::format_to(out, " {}", next++);
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
    for (const Vec3& y : sample(fabric, yarn, q, 1)) {
      for (const double coordinate : y) append(bytes, static_cast<float>(coordinate));
    }
  }
  return bytes;
}

}  // namespace wale
