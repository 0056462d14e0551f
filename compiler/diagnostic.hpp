/// What the compiler tells a user about a text: where, what, and what to write instead.
#pragma once

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

class Diagnostics {
 public:
  void report(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }
  void error(std::string_view code, Span span, std::string message, std::string hint = {});
  void warning(std::string_view code, Span span, std::string message, std::string hint = {});
  bool failed() const { return error_count() > 0; }
  std::size_t error_count() const;  ///< so that a pass can tell its own errors from earlier ones
  const std::vector<Diagnostic>& all() const { return all_; }
  /// Puts those after the first `kept` into the order of their text, for a reader goes from top to bottom.
  void order_by_place(std::size_t kept);

 private:
  std::vector<Diagnostic> all_;
};

/// `file:line:col: error: message [code]`, the source line, carets, and the hint.
std::string print(const Diagnostic&);

}  // namespace wale
