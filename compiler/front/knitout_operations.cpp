#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "compiler/front/knitout_codes.hpp"
#include "compiler/front/knitout_parts.hpp"
#include "compiler/front/limits.hpp"
#include "compiler/spelling.hpp"

namespace wale {
namespace {

/// Which operands an operation has, in this order.
struct Form {
  std::string_view name;
  Op op = Op::pause;
  bool direction = false;
  int needles = 0, numbers = 0;
  bool carriers = false;
};

constexpr std::array<Form, 15> forms{{{"knit", Op::knit, true, 1, 0, true},
                                      {"xfer", Op::split, false, 2, 0, false},
                                      {"tuck", Op::tuck, true, 1, 0, true},
                                      {"drop", Op::knit, false, 1, 0, false},
                                      {"miss", Op::miss, true, 1, 0, true},
                                      {"rack", Op::rack, false, 0, 1, false},
                                      {"split", Op::split, true, 2, 0, true},
                                      {"amiss", Op::tuck, false, 1, 0, false},
                                      {"in", Op::in, false, 0, 0, true},
                                      {"out", Op::out, false, 0, 0, true},
                                      {"inhook", Op::inhook, false, 0, 0, true},
                                      {"outhook", Op::outhook, false, 0, 0, true},
                                      {"releasehook", Op::releasehook, false, 0, 0, true},
                                      {"stitch", Op::stitch, false, 0, 2, false},
                                      {"pause", Op::pause, false, 0, 0, false}}};

/// More words than any operation with all carriers has; the rest of a longer line is not looked at.
constexpr std::size_t most_words = limits::most_carriers + 6;

void split_words(std::string_view text, std::vector<std::string_view>& words) {
  constexpr std::string_view blanks = " \t";
  words.clear();
  for (std::size_t at = text.find_first_not_of(blanks); at != text.npos && words.size() < most_words;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(blanks, end);
  }
}

/// Numbers that no machine integer holds become the greatest: the needle is then refused for lying too far out.
std::optional<int> whole_number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  int value = 0;
  const char* end = word.data() + word.size();
  const auto [stopped, failed] = std::from_chars(word.data(), end, value);
  if (stopped != end || failed == std::errc::invalid_argument) return std::nullopt;
  using Limits = std::numeric_limits<int>;
  if (failed == std::errc::result_out_of_range) return word.starts_with('-') ? Limits::min() : Limits::max();
  return value;
}

std::optional<Needle> needle_in(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, Bed>, 4> beds{
      {{"fs", Bed::front_slider}, {"bs", Bed::back_slider}, {"f", Bed::front}, {"b", Bed::back}}};
  for (const auto& [name, bed] : beds) {
    if (!word.starts_with(name)) continue;
    if (const auto index = whole_number(word.substr(name.size()))) return Needle{bed, *index};
    return std::nullopt;
  }
  return std::nullopt;
}

/// Reads the operands of one operation from left to right, and stops at the first that is wrong.
class Operands {
 public:
  Operands(const Form& form, std::string_view operation, KnitoutReading& reading)
      : form_(form), operation_(operation), reading_(reading) {}

  std::optional<Instruction> read() {
    Instruction made;
    made.op = form_.op;
    made.span = reading_.span_of(operation_);
    if (form_.direction && !read_direction(made.direction)) return std::nullopt;
    if (form_.needles > 0 && !read_needle(made.needle)) return std::nullopt;
    if (form_.needles > 1 && !read_needle(made.other)) return std::nullopt;
    for (int i = 0; i < form_.numbers; ++i)
      if (!read_number(made.value[i])) return std::nullopt;
    if (!(form_.carriers ? read_carriers(made.carriers) : check_end())) return std::nullopt;
    return made;
  }

 private:
  bool fail(std::string_view code, std::string_view at, std::string message, std::string hint) const {
    reading_.say.error(code, reading_.span_of(at), std::move(message), std::move(hint));
    return false;
  }

  /// The next word; empty, and told, if there is none.
  std::string_view take(std::string_view wanted) {
    if (next_ < reading_.words.size()) return reading_.words[next_++];
    fail(codes::operand_missing, operation_, fmt::format("\"{}\" lacks {}", form_.name, wanted), usage());
    return {};
  }

  bool read_direction(Direction& direction) {
    const std::string_view word = take("a direction");
    if (word.empty()) return false;
    if (word != "+" && word != "-")
      return fail(codes::not_a_direction, word, fmt::format("{} is not a direction", quoted(word)), "write + or -");
    direction = word == "+" ? Direction::increasing : Direction::decreasing;
    return true;
  }

  bool read_needle(Needle& needle) {
    const std::string_view word = take("a needle");
    if (word.empty()) return false;
    const auto read = needle_in(word);
    if (!read)
      return fail(codes::not_a_needle, word, fmt::format("{} is not a needle", quoted(word)),
                  "write f or b (fs or bs for sliders) and a number, as in f12");
    needle = *read;
    return true;
  }

  bool read_number(double& number) {
    const std::string_view word = take("a number");
    if (word.empty()) return false;
    const auto read = number_in(word);
    if (!read) return fail(codes::not_a_number, word, fmt::format("{} is not a number", quoted(word)), usage());
    number = *read;
    return true;
  }

  bool read_carriers(std::vector<int>& carriers) {
    if (reading_.words.size() == most_words)
      return fail(codes::operand_extra, reading_.words.back(), "this names more carriers than any machine has",
                  "name each carrier once");
    carriers.reserve(reading_.words.size() - next_);
    for (; next_ < reading_.words.size(); ++next_) {
      const auto carrier = find_carrier(reading_.words[next_]);
      if (!carrier) return false;
      carriers.push_back(*carrier);
    }
    return true;
  }

  /// A carrier that no header names is told once, and known from then on.
  std::optional<int> find_carrier(std::string_view name) const {
    const auto& known = reading_.program.carriers;
    const auto at = std::find(known.begin(), known.end(), name);
    if (at != known.end()) return static_cast<int>(at - known.begin());
    if (reading_.has_carriers && reading_.say.keeps(codes::carrier_undeclared))
      fail(codes::carrier_undeclared, name, fmt::format("the header does not name a carrier {}", quoted(name)),
           suggest(name, {known.begin(), known.end()}));
    return add_carrier(name, reading_);
  }

  bool check_end() const {
    if (next_ == reading_.words.size() || form_.op == Op::pause) return true;  // programs write a message after pause
    return fail(codes::operand_extra, reading_.words[next_],
                fmt::format("\"{}\" takes nothing more, but {} follows", form_.name, quoted(reading_.words[next_])),
                usage());
  }

  std::string usage() const {
    std::string text = fmt::format("write `{}", form_.name);
    if (form_.direction) text += " +";
    if (form_.needles > 0) text += " f0";
    if (form_.needles > 1) text += " b0";
    if (form_.op == Op::rack) text += " 1";
    if (form_.op == Op::stitch) text += " 25 40";
    if (form_.carriers) text += " 1";
    return text + "`";
  }

  const Form& form_;
  std::string_view operation_;
  KnitoutReading& reading_;
  std::size_t next_ = 1;  // word; the operation's name is the first
};

void read_extension(std::string_view operation, KnitoutReading& reading) {
  const std::string_view name = reading.words[0];
  const auto [known, is_new] =
      reading.extensions.try_emplace(operation, static_cast<int>(reading.program.extensions.size()));
  if (is_new) reading.program.extensions.emplace_back(operation);
  Instruction& made = reading.program.code.emplace_back();
  made.op = Op::extension;
  made.extension = known->second;
  made.span = reading.span_of(operation);
  if (name != "x-stitch-number" && reading.say.keeps(codes::extension_passed_over) &&
      reading.extensions_told.insert(name).second)
    reading.say.note(codes::extension_passed_over, reading.span_of(name),
                     fmt::format("{} changes no loop and is passed over", quoted(name)));
}

void report_unknown(std::string_view name, KnitoutReading& reading) {
  std::vector<std::string_view> known;
  if (reading.say.keeps(codes::unknown_operation))
    for (const Form& form : forms) known.push_back(form.name);
  reading.say.error(codes::unknown_operation, reading.span_of(name),
                    fmt::format("{} is not an operation", quoted(name)), suggest(name, known));
}

}  // namespace

void read_operation(std::string_view line, KnitoutReading& reading) {
  const std::string_view operation = trimmed(line.substr(0, line.find(';')));
  if (operation.empty()) return;
  split_words(operation, reading.words);
  const std::string_view name = reading.words[0];
  const auto form = std::find_if(forms.begin(), forms.end(), [&](const Form& one) { return one.name == name; });
  if (form != forms.end()) {
    if (auto made = Operands(*form, operation, reading).read()) reading.program.code.push_back(std::move(*made));
  } else if (name.starts_with("x-")) {
    read_extension(operation, reading);
  } else {
    report_unknown(name, reading);
  }
}

}  // namespace wale
