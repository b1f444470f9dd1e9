// The list of candidate effects, which each file of this folder enters its effect into.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {

/// A candidate for logs of this excitation.
using CandidateFactory = fit::Candidate (*)(const fit::Excitation& excitation);

/// Enters an effect into the list: one static object in the effect's own file does it. No search nor judgement names
/// it. `place` is its place in the list and on the reference page; no two effects have the same.
struct CandidateEntry {
  CandidateEntry(int place, CandidateFactory factory);
};

/// All candidates for logs of this excitation, in the order of their places.
/// Throws std::logic_error where two effects claim the same place.
std::vector<fit::Candidate> candidates(const fit::Excitation& excitation);

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
