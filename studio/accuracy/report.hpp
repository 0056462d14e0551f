/// A study as files.
#pragma once

#include <string>

#include "studio/accuracy/study.hpp"

namespace wale {

/// One line a trial: knob, value, what it cost, what was read off, its errors against the reference and of the knob
/// alone. SI units; `nan` where a number is not known.
std::string accuracy_csv(const Study&);

/// All of it with orders and sentences, as docs/accuracy.md lists.
std::string accuracy_json(const Study&);

/// A page that needs nothing else: work-precision diagrams, orders, one sentence a knob.
std::string accuracy_html(const Study&);

}  // namespace wale
