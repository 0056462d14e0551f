/// A study in plain words.
#pragma once

#include <string>

#include "studio/accuracy/study.hpp"

namespace wale {

/// "3.1 %", "0.04 %", with two digits; "unknown" if it is not finite.
std::string percent(double share);

/// "24 instead of 16 segments a stitch: error 3.1 % → 0.4 %, 2.6 times the time": from the trial before the scene as
/// written to that, or from there to the next. Of a choice one part for each other trial. Errors are of the stress, in
/// a scene that strains nothing of the relaxed yarns' places.
std::string sentence(const Ladder&);

/// What the scene as written costs and errs, and by how much the reference itself may be off.
std::string summary_sentence(const Study&);

/// What sentence() calls the error of a trial.
double headline(const Errors&);

}  // namespace wale
