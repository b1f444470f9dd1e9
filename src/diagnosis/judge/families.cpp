// Families of laws.
#include "diagnosis/judge/families.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kLittleMore = 1.0 + 1e-6;  // the simpler law is the better one, and by no more

// The hypotheses that stand for one where it errs no less than they do: with the simpler law that one of its laws
// contains in its place. A trend for each log follows whatever is slow: any laws without one are simpler.
std::vector<int> simplerThan(const Evidence& evidence, int hypothesis, int member) {
  std::vector<int> simpler;
  if (evidence.single(member).free_trends) {
    for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
      const HypothesisEvidence& other = evidence.at(h);
      if (other.members.size() == evidence.at(hypothesis).members.size() && !other.free_trends &&
          !other.like_parameters && !other.last_resort && std::isfinite(other.held_out)) {
        simpler.push_back(h);
      }
    }
    return simpler;
  }
  const int contained = evidence.contains.empty() ? -1 : evidence.contains[static_cast<std::size_t>(member)];
  if (const auto found = contained < 0 ? std::nullopt : evidence.inPlaceOf(hypothesis, member, contained)) {
    simpler.push_back(*found);
  }
  return simpler;
}

}  // namespace

void settleFamilies(Evidence& evidence, const Criteria& criteria) {
  const Weighing weighing(evidence, criteria);
  for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
    for (const int member : evidence.at(h).members) {
      for (const int simpler : simplerThan(evidence, h, member)) {
        if (!weighing.errsLess(evidence.at(h), evidence.at(simpler))) {
          HypothesisEvidence& large = evidence.hypotheses[static_cast<std::size_t>(h)];
          large.does_no_better = true;
          large.at_least = std::max(large.at_least, kLittleMore * weighing.left(evidence.at(simpler)));
        }
      }
    }
  }
}

}  // namespace rubber_suspension::diagnosis
