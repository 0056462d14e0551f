/// One finding for each kind, at the first place: a whole course of them is one mistake.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "compiler/diagnostic.hpp"

namespace wale::passes {

struct Finding {
  Span first;
  int count = 0;
  void add(const Span& span) {
    if (count++ == 0) first = span;
  }
};

/// Nothing if there is none; `message (and 3 more)` if there are several.
inline void tell_once(const Finding& found, Severity severity, std::string_view code, std::string message,
                      std::string hint, Diagnostics& say) {
  if (found.count == 0) return;
  if (found.count > 1) message += fmt::format(" (and {} more)", found.count - 1);
  say.report({severity, code, found.first, std::move(message), std::move(hint)});
}

}  // namespace wale::passes
