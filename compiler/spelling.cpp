#include "compiler/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace wale {
namespace {

bool same(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int change = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

std::string_view nearest(std::string_view written, const std::vector<std::string_view>& known) {
  std::string_view best;
  if (written.size() > 40) return best;
  const int letters = static_cast<int>(written.size());
  int least = std::min(letters, std::max(1, letters / 3) + 1);
  for (const std::string_view word : known) {
    const int distance = edit_distance(written, word);
    if (distance < least) {
      least = distance;
      best = word;
    }
  }
  return best;
}

std::string suggest(std::string_view written, const std::vector<std::string_view>& known) {
  const std::string_view near = nearest(written, known);
  if (!near.empty()) return fmt::format("did you mean \"{}\"?", near);
  return fmt::format("known are {}", fmt::join(known, ", "));
}

}  // namespace wale
