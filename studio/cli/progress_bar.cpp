#include "studio/cli/progress_bar.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wale {
namespace {

constexpr double quiet_at_first = 2, terminal_interval = 0.2, log_interval = 5;  // s
constexpr int bar_width = 30;

double seconds(std::chrono::steady_clock::duration span) { return std::chrono::duration<double>(span).count(); }

std::string clock_text(double time) {
  const long whole = std::lround(time);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string bar(double fraction) {
  const int done = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * bar_width));
  return '[' + std::string(static_cast<std::size_t>(done), '#') +
         std::string(static_cast<std::size_t>(bar_width - done), '.') + ']';
}

}  // namespace

ProgressBar::ProgressBar(bool wanted) : terminal_(::isatty(STDERR_FILENO) == 1), enabled_(terminal_ || wanted) {}

void ProgressBar::show(const RunStatus& status) {
  if (!enabled_) return;
  const Clock::time_point now = Clock::now();
  const bool new_stage = status.stage_index != stage_;
  if (new_stage) {
    stage_ = status.stage_index;
    stage_begin_ = now;
    stage_begin_fraction_ = status.fraction;
  }
  if (seconds(now - begin_) < quiet_at_first) return;
  if (!new_stage && seconds(now - last_shown_) < (terminal_ ? terminal_interval : log_interval)) return;
  last_shown_ = now;

  const double left = seconds_left(status);
  const std::string remaining = std::isfinite(left) ? fmt::format("  {} left in this stage", clock_text(left)) : "";
  const std::string residual = status.residual ? fmt::format("  residual {:.2g} mN", 1e3 * *status.residual) : "";
  const std::string text = fmt::format("{:<8} {}/{}  {} {:3.0f} %{}{}", status.stage, status.stage_index + 1,
                                       status.stages, bar(status.fraction), 100 * status.fraction, residual, remaining);
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r\x1b[K" : "", text, terminal_ ? "" : "\n");
  std::fflush(stderr);
  dirty_ = terminal_;
}

void ProgressBar::clear() {
  if (!dirty_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  dirty_ = false;
}

double ProgressBar::seconds_left(const RunStatus& status) const {
  const double done = status.fraction - stage_begin_fraction_;
  if (done <= 0) return INFINITY;
  return seconds(Clock::now() - stage_begin_) * std::max(0.0, 1 - status.fraction) / done;
}

}  // namespace wale
