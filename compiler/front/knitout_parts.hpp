/// What stands between the text of a knitout file and its program: the reader's own nouns.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/diagnostic.hpp"
#include "compiler/program.hpp"

namespace wale {

/// What is known so far; every `part` and every word is a view into the source's text.
struct KnitoutReading {
  const Source& source;
  Diagnostics& say;
  Program program;
  bool has_carriers = false;  ///< a header names them
  std::set<std::string> headers_seen;
  std::unordered_map<std::string_view, int> extensions;  ///< line -> index into Program::extensions
  std::set<std::string_view> extensions_told;            ///< names that a note was given for
  std::vector<std::string_view> words;                   ///< of the line at hand; kept for its memory

  Span span_of(std::string_view part) const {
    const auto begin = static_cast<std::uint32_t>(part.data() - source.text.data());
    return {&source, begin, begin + static_cast<std::uint32_t>(part.size())};
  }
};

/// A line after the first; false if it is no header, so that the block of headers ends here.
bool read_header(std::string_view line, KnitoutReading&);

/// A line of the body, comment and all. What cannot be understood is reported and left out.
void read_operation(std::string_view line, KnitoutReading&);

/// The index of a carrier; adds it. Nothing if there are more than any machine has.
std::optional<int> add_carrier(std::string_view name, KnitoutReading&);

/// A whole word as a finite number, with or without a sign.
std::optional<double> number_in(std::string_view word);

/// The beginning of `word` in quotes; what is no character is written as in C.
std::string quoted(std::string_view word);

std::string_view trimmed(std::string_view text);

}  // namespace wale
