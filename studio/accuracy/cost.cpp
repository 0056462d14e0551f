#include "studio/accuracy/cost.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

namespace wale {
namespace {

double processor_seconds() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Linux counts the peak anew from here; see proc(5), clear_refs.
void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    double kilobytes = 0;
    status >> kilobytes;
    return kilobytes / 1e3;
  }
  return 0;
}

double middle(std::vector<double> values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), half, values.end());
  return *half;
}

}  // namespace

Cost cost_of(const std::function<void()>& work) {
  forget_peak_memory();
  const auto begun = std::chrono::steady_clock::now();
  const double processor = processor_seconds();
  work();
  Cost cost;
  cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  cost.processor = processor_seconds() - processor;
  cost.memory = peak_megabytes();
  return cost;
}

Cost median(std::vector<Cost> costs) {
  Cost all = costs.back();
  std::vector<double> wall, processor;
  for (const Cost& cost : costs) {
    wall.push_back(cost.wall);
    processor.push_back(cost.processor);
  }
  all.wall = middle(std::move(wall));
  all.processor = middle(std::move(processor));
  return all;
}

}  // namespace wale
