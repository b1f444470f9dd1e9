// Verdict by sums of the posterior.
#include "diagnosis/judge/answer.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kOfAllSets = 0.9;  // that the sets listed hold the right one
constexpr double kMajority = 0.5;   // of all sets, that one has to have to stand for itself

// The fewest sets that have this share of all, from the likeliest on.
std::vector<std::vector<int>> likeliest(const SetPosterior& posterior) {
  const double enough = kOfAllSets * posterior.ofSets();
  std::vector<std::vector<int>> sets;
  double sum = 0.0;
  for (const SetProbability& set : posterior.sets) {
    if (sum >= enough) {
      break;
    }
    sets.push_back(set.members);
    sum += set.sum();
  }
  return sets;
}

std::vector<int> largestFirst(const SetProbability& set) {
  std::vector<std::size_t> order(set.members.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return set.sizes[a] > set.sizes[b]; });
  std::vector<int> effects;
  std::transform(order.begin(), order.end(), std::back_inserter(effects),
                 [&](std::size_t i) { return set.members[i]; });
  return effects;
}

std::vector<double> ofEffects(const SetPosterior& posterior, std::size_t effects) {
  std::vector<double> probabilities(effects, 0.0);
  for (const SetProbability& set : posterior.sets) {
    for (const int member : set.members) {
      probabilities[static_cast<std::size_t>(member)] += set.sum();
    }
  }
  return probabilities;
}

Verdict verdictOf(const SetProbability& likeliest, double all) {
  if (likeliest.sum() < kMajority * all) {
    return Verdict::confounded;
  }
  return likeliest.beside > likeliest.alone ? Verdict::partly : Verdict::named;
}

void name(const SetPosterior& posterior, Answer& answer) {
  const SetProbability& best = posterior.sets.front();
  answer.verdict = verdictOf(best, posterior.ofSets());
  answer.effects = largestFirst(best);
  answer.model = best.hypothesis;
  answer.probability = best.sum();
  answer.confounded = likeliest(posterior);
}

}  // namespace

Answer answer(const SetPosterior& posterior, std::size_t effects) {
  Answer answer;
  const double sets = posterior.ofSets();
  answer.posterior = {posterior.none, posterior.parameter_error, sets, posterior.unknown};
  answer.candidates = ofEffects(posterior, effects);
  answer.probability = std::max({posterior.none, posterior.parameter_error, posterior.unknown});
  if (sets > answer.probability) {
    name(posterior, answer);
  } else if (answer.probability == posterior.none) {
    answer.verdict = Verdict::none;
    answer.model = Evidence::kAsConfigured;
  } else {
    answer.verdict = answer.probability == posterior.unknown ? Verdict::unknown : Verdict::parameter_error;
  }
  return answer;
}

Answer answer(const NamedEvidence& named, const JudgeNumbers& numbers) {
  return answer(setPosterior(scoreTable(named), numbers), named.effects.size());
}

}  // namespace rubber_suspension::diagnosis
