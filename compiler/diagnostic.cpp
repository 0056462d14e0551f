#include "compiler/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace wale {
namespace {

constexpr std::size_t widest_excerpt = 110;  // bytes of a source line that are shown

std::string_view word(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return {};
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

struct LineEnds {
  std::size_t begin = 0, end = 0;  // bytes of the source, without the line end
};

LineEnds line_of(const Span& span) {
  const std::string_view text = span.source->text;
  const std::size_t begin = std::min<std::size_t>(span.begin, text.size());
  LineEnds line{begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1, std::min(text.find('\n', begin), text.size())};
  if (line.end > line.begin && text[line.end - 1] == '\r') --line.end;
  return line;
}

/// The source line with carets under the span; long lines are cut around it.
std::string excerpt(const Span& span) {
  const std::string_view text = span.source->text;
  const std::size_t begin = std::min<std::size_t>(span.begin, text.size());
  const auto [line_begin, line_end] = line_of(span);

  std::size_t first = line_begin;
  if (begin - first > widest_excerpt * 2 / 3) first = begin - widest_excerpt / 2;
  while (first < begin && continues_character(text[first])) ++first;
  std::size_t last = std::min(line_end, first + widest_excerpt);
  while (last < line_end && continues_character(text[last])) ++last;

  const std::size_t end = std::clamp<std::size_t>(span.end, std::min(begin, last), last);
  const std::string_view before = text.substr(first, begin - first);
  const std::string_view marked = text.substr(begin, end - std::min(begin, end));
  std::string shown{text.substr(first, last - first)};
  // Tabs would shift the carets, other control characters the user's terminal.
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return fmt::format("    {}\n    {}{}\n", shown, std::string(characters(before), ' '),
                     std::string(std::max<std::size_t>(1, characters(marked)), '^'));
}

/// Knitout is mostly written by programs, which may say for a line where in their own text it comes from.
std::string written_by(const Span& span) {
  constexpr std::string_view mark = ";!source:";
  const LineEnds ends = line_of(span);
  const std::string_view line = std::string_view(span.source->text).substr(ends.begin, ends.end - ends.begin);
  const std::size_t at = line.find(mark);
  if (at == std::string_view::npos) return {};
  return fmt::format("  source:{}\n", line.substr(at + mark.size()));
}

}  // namespace

void Diagnostics::report(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++errors_;
  if (++counts_[diagnostic.code] <= most_of_a_code) all_.push_back(std::move(diagnostic));
}

void Diagnostics::error(std::string_view code, Span span, std::string message, std::string hint) {
  report({Severity::error, code, span, std::move(message), std::move(hint)});
}

void Diagnostics::warning(std::string_view code, Span span, std::string message, std::string hint) {
  report({Severity::warning, code, span, std::move(message), std::move(hint)});
}

void Diagnostics::note(std::string_view code, Span span, std::string message, std::string hint) {
  report({Severity::note, code, span, std::move(message), std::move(hint)});
}

void Diagnostics::order_by_place(std::size_t kept) {
  std::stable_sort(all_.begin() + static_cast<std::ptrdiff_t>(std::min(kept, all_.size())), all_.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.span.begin < b.span.begin; });
}

std::string print(const Diagnostic& diagnostic) {
  std::string text;
  if (diagnostic.span.source) {
    const LineColumn place = locate(diagnostic.span);
    text = fmt::format("{}:{}:{}: ", diagnostic.span.source->name, place.line, place.column);
  }
  text += fmt::format("{}: {} [{}]\n", word(diagnostic.severity), diagnostic.message, diagnostic.code);
  if (diagnostic.span.source) text += excerpt(diagnostic.span);
  if (diagnostic.span.source) text += written_by(diagnostic.span);
  if (!diagnostic.hint.empty()) text += fmt::format("  hint: {}\n", diagnostic.hint);
  return text;
}

}  // namespace wale
