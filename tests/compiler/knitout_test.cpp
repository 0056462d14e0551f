#include <gtest/gtest.h>

#include <memory>

#include "compiler/front/knitout_codes.hpp"
#include "compiler/passes.hpp"

namespace wale {
namespace {

using Codes = std::vector<std::string_view>;

const std::string head = ";!knitout-2\n;;Carriers: 1 2 3\n";

struct Read {
  Source source;
  Diagnostics say;
  Program program;
};

/// Spans point into `source`, so it stays where it is.
std::unique_ptr<Read> read(const std::string& text) {
  auto made = std::make_unique<Read>();
  made->source = {"test.k", text};
  made->program = passes::parse_knitout(made->source, made->say);
  return made;
}

Codes codes_of(const std::string& text) {
  Codes found;
  const auto made = read(text);
  for (const Diagnostic& one : made->say.all()) found.push_back(one.code);
  return found;
}

/// The place and the words of the only diagnostic.
std::string only(const std::string& text) {
  const auto made = read(text);
  EXPECT_EQ(made->say.all().size(), 1u);
  if (made->say.all().empty()) return {};
  const Diagnostic& one = made->say.all().front();
  EXPECT_FALSE(one.hint.empty());
  const LineColumn at = locate(one.span);
  return std::to_string(at.line) + ":" + std::to_string(at.column) + " " + one.message;
}

TEST(Knitout, ReadsEveryOperation) {
  const std::string text =
      ";!knitout-2\n;;Carriers: 1 2 3\nin 1\ninhook 2 3\nstitch 25 -40.5\nrack -0.75\nknit + f3 1\nknit - b-2 2 3\n"
      "tuck + fs0 1\nsplit - f3 b4 1\nmiss + bs3 2\nreleasehook 2 3\ndrop f3\namiss b3\nxfer f3 bs3\npause\n"
      "x-stitch-number 5\nouthook 2 3\nout 1\n";
  const auto made = read(text);
  EXPECT_TRUE(made->say.all().empty());
  EXPECT_EQ(made->program.code.size(), 17u);
  EXPECT_EQ(print(made->program), text);
}

TEST(Knitout, ReadsOperationsWithoutYarnAsTheirOtherNames) {
  const auto made = read(head + "knit + f1\ntuck - f2\nsplit + f1 b1\ndrop f1\n");
  EXPECT_EQ(made->program.code[0].op, Op::knit);
  EXPECT_TRUE(made->program.code[0].carriers.empty());
  EXPECT_EQ(made->program.code[3].op, Op::knit);
  EXPECT_EQ(print(made->program), head + "knit + f1\ntuck - f2\nsplit + f1 b1\ndrop f1\n");
}

TEST(Knitout, TakesBlanksCommentsAndSigns) {
  const auto made = read(head + "\n  \t\n;; late\n  knit\t+   f+3  1;comment\nrack +0.25;\nmiss - f-7 2 ;!source: a:1");
  EXPECT_TRUE(made->say.all().empty());
  EXPECT_EQ(print(made->program), head + "knit + f3 1\nrack 0.25\nmiss - f-7 2\n");
}

TEST(Knitout, KnowsTheMachineItsGaugeAndTheYarns) {
  const auto made = read(
      ";!knitout-2\n;;Machine: SWG091N2\n;;Gauge: 15\n;;Yarn-2: 50-50 Rust\n;;Carriers: 1 2\n;;Position: Right\n"
      ";;Width: 530\n;;X-Maker: someone\nknit + f0 1\n");
  EXPECT_TRUE(made->say.all().empty());
  EXPECT_EQ(made->program.machine, "SWG091N2");
  EXPECT_EQ(made->program.gauge, 15);
  EXPECT_EQ(made->program.position, "Right");
  ASSERT_EQ(made->program.headers.size(), 3u);
  EXPECT_EQ(made->program.headers[0].name, "Yarn-2");
  EXPECT_EQ(made->program.headers[0].value, "50-50 Rust");
  EXPECT_EQ(print(read(print(made->program))->program), print(made->program));
}

TEST(Knitout, ReadsCarriersThatShareARail) {
  const auto made = read(";!knitout-2\n;;Carriers: L1,L2;R1,R2 3\nin R2\n");
  EXPECT_EQ(made->program.carriers, (std::vector<std::string>{"L1", "L2", "R1", "R2", "3"}));
  EXPECT_EQ(print(made->program), ";!knitout-2\n;;Carriers: L1,L2;R1,R2 3\nin R2\n");
}

TEST(Knitout, KeepsEachLineOfAnExtensionAndTellsItsNameOnce) {
  const auto made = read(head + "x-roller-advance 100\nx-roller-advance  200 ; more\nx-roller-advance 100\n");
  ASSERT_EQ(made->say.all().size(), 1u);
  EXPECT_EQ(made->say.all()[0].code, codes::extension_passed_over);
  EXPECT_EQ(made->say.all()[0].severity, Severity::note);
  EXPECT_EQ(made->program.extensions.size(), 2u);
  EXPECT_EQ(print(made->program), head + "x-roller-advance 100\nx-roller-advance  200\nx-roller-advance 100\n");
}

TEST(Knitout, PointsAtTheWordThatIsWrong) {
  EXPECT_EQ(only(head + "knit + g2 1\n"), "3:8 \"g2\" is not a needle");
  EXPECT_EQ(only(head + "knit * f2 1\n"), "3:6 \"*\" is not a direction");
  EXPECT_EQ(only(head + "knti + f2 1\n"), "3:1 \"knti\" is not an operation");
  EXPECT_EQ(only(head + "knit + f2 4\n"), "3:11 the header does not name a carrier \"4\"");
  EXPECT_EQ(only(head + "xfer f2\n"), "3:1 \"xfer\" lacks a needle");
  EXPECT_EQ(only(head + "drop f2 1\n"), "3:9 \"drop\" takes nothing more, but \"1\" follows");
  EXPECT_EQ(only(head + "rack one\n"), "3:6 \"one\" is not a number");
  EXPECT_EQ(only(head + "rack inf\n"), "3:6 \"inf\" is not a number");
  EXPECT_EQ(only(head + "rack 1e999\n"), "3:6 \"1e999\" is not a number");
  EXPECT_EQ(only(head + "rack\n"), "3:1 \"rack\" lacks a number");
  EXPECT_EQ(only(head + "stitch 5\n"), "3:1 \"stitch\" lacks a number");
}

TEST(Knitout, LeavesOutALineAtFaultAndReadsOn) {
  const auto made = read(head + "knit + f2 1\nknit + 2 1\nknit + f3 1\n");
  EXPECT_EQ(print(made->program), head + "knit + f2 1\nknit + f3 1\n");
  EXPECT_TRUE(made->say.failed());
}

TEST(Knitout, TellsOfAnUndeclaredCarrierOnce) {
  EXPECT_EQ(codes_of(head + "in 9\nknit + f0 9\nout 9\n"), Codes{codes::carrier_undeclared});
}

TEST(Knitout, WantsTheMagicLineFirst) {
  EXPECT_EQ(only(";!knitout\n;;Carriers: 1\nin 1\n"), "1:1 the first line does not say that this is knitout");
  const auto made = read("inhook 2\nknit + f0 2\n");
  EXPECT_EQ(made->say.all().at(0).code, codes::not_knitout);
  EXPECT_EQ(made->program.code.size(), 2u) << "the first line is then an operation";
  EXPECT_EQ(codes_of(""), (Codes{codes::not_knitout, codes::no_carriers_header}));
}

TEST(Knitout, WarnsOfHeadersThatAreOdd) {
  EXPECT_EQ(codes_of(";!knitout-3\n;;Carriers: 1\n"), Codes{codes::newer_version});
  EXPECT_EQ(codes_of(";!knitout-99999999999\n;;Carriers: 1\n"), Codes{codes::newer_version});
  EXPECT_EQ(codes_of(";!knitout-2\nin 1\n"), Codes{codes::no_carriers_header});
  EXPECT_EQ(codes_of(";!knitout-2\n;;Carriers: 1\n;;Carriers: 2\nin 2\n"), Codes{codes::header_twice});
  EXPECT_EQ(codes_of(";!knitout-2\n;;note\n;;Carriers: 1\nin 1\n"), Codes{codes::no_header});
  EXPECT_EQ(codes_of(";!knitout-2\n;;Carriers: 1\n;;Machin: x\n"), Codes{codes::unknown_header});
  EXPECT_EQ(codes_of(";!knitout-2\n;;Carriers: 1\n;;Gauge: fine\n"), Codes{codes::header_value});
  EXPECT_EQ(codes_of(";!knitout-2\n;;Carriers: 1\n;;Position: up\n"), Codes{codes::header_value});
  EXPECT_EQ(codes_of(";!knitout-2\n;;Carriers: 1 1\n"), Codes{codes::carriers_header});
  const auto odd = read(";!knitout-3\n;;note\n;;Gauge: fine\nin 1\n");
  for (const Diagnostic& one : odd->say.all()) EXPECT_EQ(one.severity, Severity::warning);
}

TEST(Knitout, EndsTheHeadersAtTheFirstOtherLine) {
  EXPECT_EQ(codes_of(";!knitout-2\n;;Carriers: 1\n\n;;Machine: x\n;;0\n"), Codes{});
  EXPECT_EQ(read(";!knitout-2\n;;Carriers: 1\n;c\n;;Machine: x\n")->program.machine, "");
}

TEST(Knitout, ReadsFilesThatWereSavedElsewhere) {
  const auto made = read("\xEF\xBB\xBF;!knitout-2\r\n;;Carriers: 1\r\nknit + f0 1\r\n");
  EXPECT_EQ(print(made->program), ";!knitout-2\n;;Carriers: 1\nknit + f0 1\n");
  EXPECT_EQ(made->say.all().size(), 2u);
  EXPECT_FALSE(made->say.failed());
}

TEST(Knitout, RefusesNulBytes) { EXPECT_EQ(codes_of(head + std::string("in 1 ;\0\n", 8)), Codes{codes::nul_byte}); }

TEST(Knitout, PrintsWhereAProgramSaysThatALineComesFrom) {
  const auto made = read(head + "knit + g2 1 ;!source:hat.js:12:3\n");
  EXPECT_NE(print(made->say.all().at(0)).find("\n  source:hat.js:12:3\n"), std::string::npos);
}

}  // namespace
}  // namespace wale
