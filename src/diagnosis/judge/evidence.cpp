// Hypotheses by their effects.
#include "diagnosis/judge/evidence.h"

#include <algorithm>

namespace rubber_suspension::diagnosis {

std::vector<int> Evidence::containedIn(int effect) const {
  return contains.empty() ? std::vector<int>() : contains[static_cast<std::size_t>(effect)];
}

std::optional<int> Evidence::find(std::vector<int> members) const {
  std::sort(members.begin(), members.end());
  const auto found = std::find_if(hypotheses.begin() + kReEstimated, hypotheses.end(),
                                  [&](const HypothesisEvidence& h) { return h.members == members; });
  return found == hypotheses.end() ? std::nullopt : std::optional<int>(static_cast<int>(found - hypotheses.begin()));
}

std::optional<int> Evidence::without(int hypothesis, int effect) const {
  std::vector<int> members = at(hypothesis).members;
  members.erase(std::remove(members.begin(), members.end(), effect), members.end());
  return find(std::move(members));
}

std::optional<int> Evidence::inPlaceOf(int hypothesis, int effect, int other) const {
  std::vector<int> members = at(hypothesis).members;
  if (other != effect && std::find(members.begin(), members.end(), other) != members.end()) {
    return std::nullopt;
  }
  std::replace(members.begin(), members.end(), effect, other);
  return find(std::move(members));
}

}  // namespace rubber_suspension::diagnosis
