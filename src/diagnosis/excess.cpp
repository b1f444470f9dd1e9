// The yardstick of search and verdict.
#include "rubber_suspension/diagnosis/excess.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kFloorMargin = 1.03;        // the floor is known to some percent only
constexpr double kInsignificantGap = 0.006;  // of the force: smaller gaps are within the accuracy of discretisation
constexpr double kDiscretisation = 1.2;      // times what the model errs by at these time steps and this noise
constexpr double kWithinNoise = 0.5;         // an excess below this part of the floor is noise
constexpr double kRestOfGap = 0.12;          // what may remain of a gap that counts as closed by own parameters
constexpr double kAboveNoise = 2.5;          // times the floor: an excess that own parameters must not leave
constexpr double kRestOfEffects = 0.16;      // what may remain of a gap without a search for one more effect
constexpr double kTrendPrice = 0.1;          // of the gap, on a free trend per log, which follows whatever is slow
constexpr double kShows = 0.67;              // of the gap: an effect that leaves less does show
constexpr double kMovedFar = 0.14;           // logarithm of an own parameter: beyond what a specification errs by
constexpr std::size_t kFewAtoms = 3;         // of an effect that is a simpler explanation than moved own parameters
constexpr double kHides = 0.3;               // part of what re-estimation leaves that a hidden effect may leave
constexpr double kMovedLittle = 0.06;        // logarithm of an own parameter: as specified
constexpr double kHidesAsSpecified = 0.6;    // as kHides, where own parameters stay as specified

}  // namespace

double excess(const Search& search, double error) {
  return std::sqrt(std::max(0.0, error * error - std::pow(kFloorMargin * search.noise, 2)));
}

double excess(const Search& search, const Trial& trial) {
  const double left = std::hypot(excess(search, trial.fit.held_out), trial.fit.departure);
  const bool trends = hasTrends(search.candidates, trial.members);
  return trends ? std::hypot(left, kTrendPrice * excess(search, search.re_estimated.fit.held_out)) : left;
}

double insignificant(const Search& search) {
  return std::max({kWithinNoise * search.noise, kInsignificantGap, kDiscretisation * search.discretisation});
}

double enough(const Search& search) {
  return std::max(kWithinNoise * search.noise, kRestOfEffects * excess(search, search.re_estimated));
}

const Trial* bestSingle(const Search& search, bool trends) {
  const Trial* best = nullptr;
  for (const Trial& trial : search.singles) {
    if ((!trends && hasTrends(search.candidates, trial.members)) || hasLastResort(search.candidates, trial.members)) {
      continue;
    }
    if (shows(search, trial.members.front()) && (best == nullptr || excess(search, trial) < excess(search, *best))) {
      best = &trial;
    }
  }
  return best;
}

bool shows(const Search& search, int candidate) {
  const auto i = static_cast<std::size_t>(candidate);
  return search.testable[i] || excess(search, search.singles[i]) < kShows * excess(search, search.re_estimated);
}

bool closedByOwnParameters(const Search& search) {
  const double configured = excess(search, search.configured_gap);
  const double left = excess(search, search.re_estimated.fit.held_out);
  if (left < insignificant(search) || left < std::min(kAboveNoise * search.noise, kRestOfGap * configured)) {
    return true;
  }
  // Every element's own parameters: they explain the gap if they leave noise only, and if most of it was already
  // closed by the numbers of the specification.
  return excess(search, search.element_level.held_out) < std::max(kWithinNoise * search.noise, 0.3 * left) &&
         left < 0.4 * configured;
}

const Trial* hiddenEffect(const Search& search) {
  const double re_estimated = excess(search, search.re_estimated);
  if (search.re_estimated.fit.point.furthestMove() <= kMovedFar) {
    return nullptr;
  }
  const Trial* best = nullptr;
  for (const Trial& trial : search.singles) {
    const bool simple = trial.atoms.size() <= kFewAtoms && !hasTrends(search.candidates, trial.members);
    const double left = excess(search, trial);
    const double move = trial.fit.point.furthestMove();
    const double hides = move < kMovedLittle ? kHidesAsSpecified : move < kMovedFar ? kHides : 0.0;
    if (simple && left < hides * re_estimated && (best == nullptr || left < excess(search, *best))) {
      best = &trial;
    }
  }
  return best;
}

}  // namespace rubber_suspension::diagnosis
