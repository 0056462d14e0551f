#include "compiler/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <string>
#include <system_error>

namespace wale {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

/// The units of udunits' database, which holds those of the yarn trade (tex, denier) too.
class UnitTable {
 public:
  UnitTable() {
    ut_set_error_message_handler(ut_ignore);  // it would print to stderr
    system_ = ut_read_xml(nullptr);
    if (!system_) {
      ut_status status = UT_SUCCESS;
      throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                              ut_get_path_xml(nullptr, &status));
    }
  }

  Unit parse(const std::string& text) const { return Unit(ut_parse(system_, text.c_str(), UT_UTF8)); }

 private:
  ut_system* system_ = nullptr;
};

const UnitTable& units() {
  static const UnitTable table;
  return table;
}

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// udunits would take a number inside or behind a unit as a factor, and let a stray bracket pass: slips of the pen. The
/// one of 1/mm is none.
bool looks_like_a_unit(std::string_view text) {
  if (text.starts_with("1/")) text.remove_prefix(2);
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) || text[0] == '-' || text[0] == '.')
    return false;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i - 1] == ' ' && std::isdigit(static_cast<unsigned char>(text[i]))) return false;
  }
  return std::count(text.begin(), text.end(), '(') == std::count(text.begin(), text.end(), ')');
}

}  // namespace

std::optional<double> parse_quantity(std::string_view text, const Dimension& wanted, Span span, Diagnostics& say) {
  const std::string hint = fmt::format("write {}, as in `{}`", wanted.noun, wanted.example);
  const std::string_view whole = trim(text);
  const std::string_view unsigned_text = whole.substr(whole.starts_with('+') ? 1 : 0);
  double number = 0;
  const auto [end, problem] =
      std::from_chars(unsigned_text.data(), unsigned_text.data() + unsigned_text.size(), number);
  const std::string_view unit_text = trim(unsigned_text.substr(static_cast<std::size_t>(end - unsigned_text.data())));
  if (problem != std::errc{} || !std::isfinite(number)) {
    say.error("U003", span, fmt::format("\"{}\" is not {}: it does not begin with a number", whole, wanted.noun), hint);
    return std::nullopt;
  }
  if (unit_text.starts_with(',')) {
    say.error("U003", span, fmt::format("\"{}\" has a decimal comma", whole), hint);
    return std::nullopt;
  }
  if (unit_text.empty()) {
    if (wanted.unit == "1") return number;
    say.error("U001", span, fmt::format("\"{}\" has no unit, and {} needs one", whole, wanted.noun), hint);
    return std::nullopt;
  }
  const Unit given = looks_like_a_unit(unit_text) ? units().parse(std::string(unit_text)) : nullptr;
  if (!given) {
    say.error("U004", span, fmt::format("\"{}\" is not a unit", unit_text), hint);
    return std::nullopt;
  }
  const Unit target = units().parse(std::string(wanted.unit));
  const std::unique_ptr<cv_converter, FreeConverter> convert(ut_get_converter(given.get(), target.get()));
  if (!convert) {
    say.error("U002", span, fmt::format("\"{}\" is not {}: its unit is of another dimension", whole, wanted.noun),
              hint);
    return std::nullopt;
  }
  return cv_convert_double(convert.get(), number);
}

}  // namespace wale
