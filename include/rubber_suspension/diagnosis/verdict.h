// From the fits of all hypotheses to a verdict: what is named, how sure it is, what cannot be told apart.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/search.h"

namespace rubber_suspension::diagnosis {

enum class VerdictKind { none, parameter_error, named, confounded, unknown, partly };

std::string toString(VerdictKind kind);

struct Verdict {
  VerdictKind kind = VerdictKind::none;
  std::vector<int> effects;           ///< candidates named, most important first
  Trial model;                        ///< what `augmented` is made of
  std::vector<double> probabilities;  ///< of each candidate to be the (most important) effect
  double probability_none_of_these = 0.0;
  std::vector<std::vector<int>> confounded;  ///< for each effect named, the set that holds it at 90 %
};

/// `most_effects`: how many effects may be named at once; with 0 a gap is parameter_error or unknown. `trends`: whether
/// an effect that frees a slow trend per log may be named.
Verdict decide(const Search& search, std::size_t most_effects = 3, bool trends = true);

}  // namespace rubber_suspension::diagnosis
