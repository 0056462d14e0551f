/// A line on stderr that says how far a run is, and how long its stage will still take.
#pragma once

#include <chrono>

#include "sim/run.hpp"

namespace wale {

/// Shows nothing in the first two seconds, nor unless stderr is a terminal or `wanted`. A terminal gets one line that
/// is rewritten up to five times a second; anything else gets a line every few seconds.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const RunStatus&);
  /// Wipes the line, so that other text can follow.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_left(const RunStatus&) const;

  bool terminal_, enabled_, dirty_ = false;
  Clock::time_point begin_ = Clock::now(), last_shown_ = begin_, stage_begin_ = begin_;
  int stage_ = -1;
  double stage_begin_fraction_ = 0;
};

}  // namespace wale
