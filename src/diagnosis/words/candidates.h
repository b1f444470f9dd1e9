// States why a candidate effect is named or not, and which effects the logs cannot show.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Reasons why a candidate is named or not.
enum class Out {
  named,            ///< it is named
  of_no_table,      ///< tables of settled loops cannot show it
  not_testable,     ///< other parameter values hide it
  removes_nothing,  ///< it may close nothing of the gap on further logs
  gap_remains,      ///< no effect is named, because a gap remains with this one
  more_than_named,  ///< its gap is larger than that of the named effects
  less_probable     ///< its gap is no larger than that of the named effects, but it is less probable
};

Out reasonOf(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// Returns the reason in half a sentence, or an empty text for a named effect.
std::string whyOut(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// Returns a sentence such as "A typical creep would not show in these logs, so these effects remain possible."
std::string notTestableText(const Diagnosis& diagnosis);

/// Returns the headline numbers of a candidate, such as "maximum force 6 kN, displacement 0.35 mm".
std::string numbersText(const Diagnosis& diagnosis, const CandidateResult& candidate);

}  // namespace rubber_suspension::diagnosis::words
