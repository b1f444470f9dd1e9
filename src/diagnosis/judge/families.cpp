// Families of laws.
#include "diagnosis/judge/families.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kLittleMore = 1.0 + 1e-6;  // the simpler law is the better one, and by no more

// The hypothesis with a simpler law in the place of one of its laws. A trend for each log follows whatever is slow:
// any laws are simpler, the best ones count.
std::optional<int> simplerOf(const Evidence& evidence, const Weighing& weighing, int hypothesis, int member) {
  if (evidence.single(member).free_trends) {
    return weighing.bestWithoutTrends(evidence.at(hypothesis).members.size());
  }
  const int contained = evidence.contains.empty() ? -1 : evidence.contains[static_cast<std::size_t>(member)];
  return contained < 0 ? std::nullopt : evidence.inPlaceOf(hypothesis, member, contained);
}

}  // namespace

void settleFamilies(Evidence& evidence, const Criteria& criteria) {
  const Weighing weighing(evidence, criteria);
  for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
    for (const int member : evidence.at(h).members) {
      const std::optional<int> simpler = simplerOf(evidence, weighing, h, member);
      if (simpler && !weighing.errsLess(evidence.at(h), evidence.at(*simpler))) {
        HypothesisEvidence& large = evidence.hypotheses[static_cast<std::size_t>(h)];
        large.does_no_better = true;
        large.at_least = std::max(large.at_least, kLittleMore * weighing.left(evidence.at(*simpler)));
      }
    }
  }
}

}  // namespace rubber_suspension::diagnosis
