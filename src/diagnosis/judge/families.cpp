// Families of laws.
#include "diagnosis/judge/families.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {

void settleFamilies(Evidence& evidence, const Criteria& criteria) {
  if (evidence.contains.empty()) {
    return;
  }
  const Weighing weighing(evidence, criteria);
  for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
    for (const int member : evidence.at(h).members) {
      const int contained = evidence.contains[static_cast<std::size_t>(member)];
      const std::optional<int> other = contained < 0 ? std::nullopt : evidence.inPlaceOf(h, member, contained);
      if (!other) {
        continue;
      }
      const HypothesisEvidence& small = evidence.at(*other);
      const PairedDifference gain = weighing.difference(evidence.at(h), small);
      if (-gain.mean <= std::max(gain.standard_error, std::log1p(criteria.family_gain))) {
        HypothesisEvidence& large = evidence.hypotheses[static_cast<std::size_t>(h)];
        large.at_least = std::max(large.at_least, (1.0 + criteria.family_gain) * weighing.left(small));
      }
    }
  }
}

}  // namespace rubber_suspension::diagnosis
