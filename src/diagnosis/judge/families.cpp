// Families of laws.
#include "diagnosis/judge/families.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {
namespace {

// The hypothesis with a simpler effect in the place of a larger one.
std::optional<int> simpler(const Evidence& evidence, int hypothesis, int larger, int contained) {
  std::vector<int> members = evidence.at(hypothesis).members;
  if (std::find(members.begin(), members.end(), contained) != members.end()) {
    return std::nullopt;
  }
  std::replace(members.begin(), members.end(), larger, contained);
  std::sort(members.begin(), members.end());
  for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
    if (evidence.at(h).members == members) {
      return h;
    }
  }
  return std::nullopt;
}

}  // namespace

void settleFamilies(Evidence& evidence, const Criteria& criteria) {
  if (evidence.contains.empty()) {
    return;
  }
  const Weighing weighing(evidence, criteria);
  for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
    for (const int member : evidence.at(h).members) {
      const int contained = evidence.contains[static_cast<std::size_t>(member)];
      const std::optional<int> other = contained < 0 ? std::nullopt : simpler(evidence, h, member, contained);
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
