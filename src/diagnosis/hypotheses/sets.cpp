// Sets of effects.
#include "diagnosis/hypotheses/sets.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace rubber_suspension::diagnosis {
namespace {

bool has(const std::vector<int>& members, int member) {
  return std::find(members.begin(), members.end(), member) != members.end();
}

// The simpler laws that one contains, but for those that another one of them contains.
std::vector<int> largestWithin(int member, const Sets& contained) {
  const std::vector<int>& laws = contained[static_cast<std::size_t>(member)];
  std::vector<int> largest;
  std::copy_if(laws.begin(), laws.end(), std::back_inserter(largest), [&](int law) {
    return std::none_of(laws.begin(), laws.end(),
                        [&](int other) { return has(contained[static_cast<std::size_t>(other)], law); });
  });
  return largest;
}

}  // namespace

Sets containedIn(const std::vector<fit::Candidate>& candidates) {
  Sets contained(candidates.size());
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    for (const std::string& simpler : candidates[c].contains) {
      const auto found = std::find_if(candidates.begin(), candidates.end(),
                                      [&](const fit::Candidate& other) { return other.effect == simpler; });
      if (found != candidates.end()) {
        contained[c].push_back(static_cast<int>(found - candidates.begin()));
      }
    }
  }
  return contained;
}

Sets withSimplerLaws(const std::vector<int>& members, const Sets& contained) {
  Sets sets;
  for (const int member : members) {
    for (const int simpler : contained[static_cast<std::size_t>(member)]) {
      if (!has(members, simpler)) {
        sets.push_back(members);
        std::replace(sets.back().begin(), sets.back().end(), member, simpler);
        std::sort(sets.back().begin(), sets.back().end());
      }
    }
  }
  return sets;
}

Sets withLawsApart(const std::vector<int>& members, const Sets& contained) {
  Sets sets;
  for (const int member : members) {
    std::set<int> apart(members.begin(), members.end());
    apart.erase(member);
    for (const int simpler : largestWithin(member, contained)) {
      apart.insert(simpler);
    }
    if (apart.size() == members.size() + 1) {
      sets.emplace_back(apart.begin(), apart.end());
    }
  }
  return sets;
}

Sets withoutOne(const std::vector<int>& members) {
  Sets sets;
  for (std::size_t i = 0; i < members.size(); ++i) {
    sets.push_back(members);
    sets.back().erase(sets.back().begin() + static_cast<std::ptrdiff_t>(i));
  }
  return sets;
}

}  // namespace rubber_suspension::diagnosis
