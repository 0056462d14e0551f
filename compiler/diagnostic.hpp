/// What the compiler tells a user about a text: where, what, and what to write instead.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/source.hpp"

namespace wale {

enum class Severity : std::uint8_t { note, warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string_view code;  ///< "C012": stable, from compiler/codes.hpp
  Span span;
  std::string message;  ///< lower case, no full stop, names in quotes
  std::string hint;     ///< an instruction; may be empty
};

/// Keeps the first hundred of each code: a machine's file repeats a mistake a million times, and nobody reads that far.
class Diagnostics {
 public:
  static constexpr std::size_t most_of_a_code = 100;

  void report(Diagnostic diagnostic);
  void error(std::string_view code, Span span, std::string message, std::string hint = {});
  void warning(std::string_view code, Span span, std::string message, std::string hint = {});
  void note(std::string_view code, Span span, std::string message, std::string hint = {});
  bool failed() const { return error_count() > 0; }
  std::size_t error_count() const { return errors_; }  ///< so that a pass can tell its own errors from earlier ones
  const std::vector<Diagnostic>& all() const { return all_; }
  /// False if a further one of this code would only be counted, so that its words need not be sought.
  bool keeps(std::string_view code) const {
    const auto found = counts_.find(code);
    return found == counts_.end() || found->second < most_of_a_code;
  }
  /// How many of each code were reported, kept or not.
  const std::map<std::string_view, std::size_t>& counts() const { return counts_; }
  /// Puts those after the first `kept` into the order of their text, for a reader goes from top to bottom.
  void order_by_place(std::size_t kept);

 private:
  std::vector<Diagnostic> all_;
  std::map<std::string_view, std::size_t> counts_;  // by code
  std::size_t errors_ = 0;
};

/// `file:line:col: error: message [code]`, the source line, carets, and the hint.
std::string print(const Diagnostic&);

}  // namespace wale
