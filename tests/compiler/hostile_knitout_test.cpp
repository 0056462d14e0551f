#include <gtest/gtest.h>

#include <chrono>

#include "compiler/compile.hpp"
#include "compiler/front/knitout_codes.hpp"

namespace wale {
namespace {

#ifdef NDEBUG
constexpr double patience = 5;  // s; most take a tenth of it on one busy core
#else
constexpr double patience = 60;  // sanitizers look at every access
#endif

const std::string head = ";!knitout-2\n;;Carriers: 1 2 3\nin 1\n";

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// Lines that differ in a number, written for `#`.
std::string numbered(const std::string& line, int count) {
  const std::size_t at = line.find('#');
  std::string all;
  for (int i = 0; i < count; ++i) all += line.substr(0, at) + std::to_string(i) + line.substr(at + 1) + "\n";
  return all;
}

struct Hostile {
  std::string name;
  std::string (*text)();
  std::string_view code;
};

class HostileKnitout : public testing::TestWithParam<Hostile> {};

TEST_P(HostileKnitout, EndsSoonInADiagnostic) {
  const Source source{"hostile.k", GetParam().text()};
  Diagnostics say;
  const auto start = std::chrono::steady_clock::now();
  knit_knitout(source, {}, say);
  std::string printed;
  for (const Diagnostic& one : say.all()) printed += print(one);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(seconds, patience);
  EXPECT_TRUE(say.counts().count(GetParam().code)) << printed.substr(0, 1000);
  EXPECT_LE(say.all().size(), 300u);
  EXPECT_LT(printed.size(), 200'000u);
}

INSTANTIATE_TEST_SUITE_P(
    Each, HostileKnitout,
    testing::Values(
        Hostile{"FarNeedle", [] { return head + "knit + f1000000000 1\n"; }, codes::needle_out_of_range},
        Hostile{"NeedleBeyondIntegers", [] { return head + "knit + f99999999999999999999 1\n"; },
                codes::needle_out_of_range},
        Hostile{"FarRack", [] { return head + "rack 1000000\n"; }, codes::racking_absurd},
        Hostile{"LongLine", [] { return head + "knit + f0 " + repeated("1 ", 5'000'000) + "\n"; },
                codes::operand_extra},
        Hostile{"LongWord", [] { return head + std::string(10'000'000, 'k') + "\n"; }, codes::unknown_operation},
        Hostile{"ManyOnOneNeedle", [] { return head + repeated("knit + f0 1\n", 2'100'000); }, codes::program_too_long},
        Hostile{"TucksOnOneNeedle", [] { return head + repeated("tuck + f0 1\n", 100'000); }, codes::stack_absurd},
        Hostile{"MovingAMountain",
                [] { return head + repeated("tuck + f0 1\n", 100) + repeated("xfer f0 b0\nxfer b0 f0\n", 500'000); },
                codes::too_many_ties},
        Hostile{"NulBytes", [] { return head + std::string(1'000'000, '\0'); }, codes::nul_byte},
        Hostile{"CarriageReturns", [] { return head + repeated("knit + f0 1\r\n", 1000); }, codes::not_plain_text},
        Hostile{"CarriageReturnsAlone", [] { return head + repeated("knit + f0 1\r", 100'000); }, codes::operand_extra},
        Hostile{"ByteOrderMark", [] { return "\xEF\xBB\xBF" + head; }, codes::not_plain_text},
        // Found by the fuzzer: written into a header this name would be two carriers of one rail.
        Hostile{"CommaInAName", [] { return std::string(";!knitout-2\nin 1,\nknit + f0 1,\nout 1,\n"); },
                codes::carriers_header},
        Hostile{"ManyCarriers", [] { return ";!knitout-2\n;;Carriers: " + repeated("ab ", 1'000'000) + "\n"; },
                codes::carriers_header},
        Hostile{"ManyHeaders", [] { return ";!knitout-2\n" + numbered(";;q#: 1", 100'000); }, codes::unknown_header},
        Hostile{"ManyMistakes", [] { return head + numbered("knti# + f0 1", 300'000); }, codes::unknown_operation},
        Hostile{"ManyUndeclared", [] { return head + numbered("knit + f0 c#", 300'000); }, codes::carrier_undeclared},
        Hostile{"ManyExtensions", [] { return head + numbered("x-q# 1", 300'000); }, codes::extension_passed_over}),
    [](const auto& name) { return name.param.name; });

}  // namespace
}  // namespace wale
