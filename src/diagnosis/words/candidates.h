// Why a candidate effect is named or not, and which effects the logs cannot show.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Reasons why a candidate is not named.
enum class Out {
  named,            ///< it is named
  of_no_table,      ///< tables of settled loops cannot show it
  not_testable,     ///< other parameter values hide it
  removes_nothing,  ///< on further logs it may close nothing of the gap
  gap_remains,      ///< no effect is named; with this one, a gap remains
  more_than_named,  ///< its gap is larger than that of the named effects
  less_probable     ///< its gap is no larger than that of the named effects, but it is less probable
};

Out reasonOf(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// Returns the reason in half a sentence; empty for a named effect.
std::string whyOut(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// Returns "A typical creep would not show in these logs, so these effects remain possible."
std::string notTestableText(const Diagnosis& diagnosis);

/// Returns "maximum force 6 kN, displacement 0.35 mm", the headline numbers of a candidate.
std::string numbersText(const Diagnosis& diagnosis, const CandidateResult& candidate);

}  // namespace rubber_suspension::diagnosis::words
