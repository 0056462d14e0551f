/// Processor time, which a busy machine changes little, and wall time.
#pragma once

#include <chrono>
#include <ctime>

namespace wale::peers {

/// Runs from when it is made.
class Stopwatch {
 public:
  /// User and system time of all threads, s.
  double processor() const { return static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC; }
  double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count(); }

 private:
  std::clock_t processor_ = std::clock();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

}  // namespace wale::peers
