// Why a candidate effect is named or not, and which effects the logs cannot show.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Why a candidate is not named.
enum class Out {
  named,            ///< it is named
  of_no_table,      ///< no table of settled loops shows it
  not_testable,     ///< other parameter values hide it
  removes_nothing,  ///< its interval on further logs holds nothing removed
  gap_remains,      ///< nothing is named, and it leaves a gap
  more_than_named,  ///< it leaves more than what is named
  less_probable     ///< it leaves no more than what is named, and is less probable
};

Out reasonOf(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// Reason in half a sentence; empty for a named effect.
std::string whyOut(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// "A typical creep would not show in these logs, so whether it is there stays open."
std::string notTestableText(const Diagnosis& diagnosis);

/// "maximum force 6 kN, displacement 0.35 mm", of the entries of a candidate.
std::string numbersText(const Diagnosis& diagnosis, const CandidateResult& candidate);

}  // namespace rubber_suspension::diagnosis::words
