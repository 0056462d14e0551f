/// Needle programs from a few lines of knitout, for tests; no checks beyond what a typing error would break.
#pragma once

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "compiler/program.hpp"

namespace wale {

inline Needle make_needle(const std::string& word) {
  static const std::map<std::string, Bed> beds{
      {"f", Bed::front}, {"b", Bed::back}, {"fs", Bed::front_slider}, {"bs", Bed::back_slider}};
  const std::size_t digits = word.find_first_of("-0123456789");
  return {beds.at(word.substr(0, digits)), std::stoi(word.substr(digits))};
}

inline Instruction make_instruction(const std::string& line, Program& program) {
  static const std::map<std::string, Op> ops{
      {"in", Op::in},     {"inhook", Op::inhook},   {"releasehook", Op::releasehook},
      {"out", Op::out},   {"outhook", Op::outhook}, {"knit", Op::knit},
      {"tuck", Op::tuck}, {"split", Op::split},     {"miss", Op::miss},
      {"rack", Op::rack}, {"stitch", Op::stitch},   {"pause", Op::pause},
      {"drop", Op::knit}, {"amiss", Op::tuck},      {"xfer", Op::split}};
  std::istringstream words(line);
  std::string word;
  words >> word;
  Instruction made;
  made.op = ops.at(word);
  const bool no_yarn = word == "drop" || word == "amiss" || word == "xfer";
  const bool at_needle = made.op == Op::knit || made.op == Op::tuck || made.op == Op::split || made.op == Op::miss;
  if (at_needle && !no_yarn)
    made.direction = (words >> word, word == "+") ? Direction::increasing : Direction::decreasing;
  if (at_needle) made.needle = (words >> word, make_needle(word));
  if (made.op == Op::split) made.other = (words >> word, make_needle(word));
  if (made.op == Op::rack) words >> made.value[0];
  if (made.op == Op::stitch) words >> made.value[0] >> made.value[1];
  while (words >> word) {
    const auto known = std::find(program.carriers.begin(), program.carriers.end(), word);
    made.carriers.push_back(static_cast<int>(known - program.carriers.begin()));
    if (known == program.carriers.end()) program.carriers.push_back(word);
  }
  return made;
}

/// One instruction a line; comment lines start with `;`. Carriers are numbered as `;;Carriers:` or else use names them.
/// The span of an instruction is its line's bytes in `text`, without a source.
inline Program make_program(const std::string& text) {
  Program program;
  std::istringstream lines(text);
  std::uint32_t begin = 0;
  for (std::string line; std::getline(lines, line); begin += static_cast<std::uint32_t>(line.size()) + 1) {
    if (line.rfind(";;Carriers:", 0) == 0) {
      std::istringstream names(line.substr(11));
      for (std::string name; names >> name;) program.carriers.push_back(name);
    }
    if (line.empty() || line[0] == ';') continue;
    Instruction made = make_instruction(line, program);
    made.span = {nullptr, begin, begin + static_cast<std::uint32_t>(line.size())};
    program.code.push_back(std::move(made));
  }
  return program;
}

}  // namespace wale
