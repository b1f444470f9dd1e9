// The verdict.
#include "rubber_suspension/diagnosis/verdict.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension {

std::string toString(VerdictKind kind) {
  static const char* const names[] = {"none", "parameter_error", "named", "confounded", "unknown", "partly"};
  return names[static_cast<int>(kind)];
}

Verdict decide(const Search& search) {
  Verdict verdict;
  verdict.model = search.re_estimated;
  verdict.probabilities.assign(search.candidates.size(), 0.0);
  const auto best = std::min_element(search.singles.begin(), search.singles.end(), [](const Trial& a, const Trial& b) {
    return a.fit.held_out < b.fit.held_out;
  });
  verdict.kind = VerdictKind::named;
  verdict.effects = best->members;
  verdict.model = *best;
  verdict.confounded = {best->members};
  verdict.probabilities[static_cast<std::size_t>(best->members[0])] = 1.0;
  return verdict;
}

}  // namespace rubber_suspension
