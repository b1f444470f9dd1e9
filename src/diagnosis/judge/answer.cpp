// Derives the verdict from sums of the posterior.
#include "diagnosis/judge/answer.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace rubber_suspension::diagnosis::judge {
namespace {

constexpr double kMajority = 0.5;       // share of the probability of all sets, below which the likeliest is confounded
constexpr double kWorthListing = 0.02;  // sets that contain a less probable effect are not listed

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

class Answering {
 public:
  Answering(const SetPosterior& posterior, std::size_t effects) : posterior_(posterior), sets_(posterior.ofSets()) {
    answer_.posterior = {posterior.none, posterior.parameter_error, sets_, posterior.unknown};
    answer_.candidates = ofEffects(posterior, effects);
  }

  Answer run() {
    std::vector<Explained> all = explanations();
    const bool names = sets_ > std::max({posterior_.none, posterior_.parameter_error, posterior_.unknown});
    std::stable_sort(all.begin(), all.end(),
                     [](const Explained& a, const Explained& b) { return a.probability > b.probability; });
    const auto said =
        std::find_if(all.begin(), all.end(), [&](const Explained& e) { return e.effects.empty() != names; });
    setVerdict(*said);
    all.erase(said);
    listAlternatives(all);
    return std::move(answer_);
  }

 private:
  std::vector<Explained> explanations() const {
    std::vector<Explained> all = {{Verdict::none, {}, Evidence::kAsConfigured, posterior_.none},
                                  {Verdict::parameter_error, {}, Evidence::kReEstimated, posterior_.parameter_error},
                                  {Verdict::unknown, {}, Evidence::kReEstimated, posterior_.unknown}};
    for (const SetProbability& set : posterior_.sets) {
      all.push_back({Verdict::named, largestFirst(set), set.hypothesis, set.sum()});
    }
    return all;
  }

  void setVerdict(const Explained& said) {
    answer_.verdict = said.effects.empty() ? said.verdict : ofLikeliestSet();
    answer_.effects = said.effects;
    answer_.model = said.model;
    answer_.probability = said.probability;
    if (!said.effects.empty()) {
      answer_.beside = posterior_.sets.front().beside / said.probability;
      listSets();
    }
  }

  Verdict ofLikeliestSet() const {
    const SetProbability& likeliest = posterior_.sets.front();
    if (likeliest.sum() < kMajority * sets_) {
      return Verdict::confounded;
    }
    return likeliest.beside > likeliest.alone ? Verdict::partly : Verdict::named;
  }

  bool isWorthListing(const std::vector<int>& members) const {
    return std::all_of(members.begin(), members.end(), [&](int member) {
      return answer_.candidates[static_cast<std::size_t>(member)] >= kWorthListing;
    });
  }

  void listSets() {
    double sum = 0.0;
    for (const SetProbability& set : posterior_.sets) {
      if (sum >= kListed * sets_) {
        return;
      }
      if (answer_.confounded.empty() || isWorthListing(set.members)) {
        answer_.confounded.push_back(set.members);
      }
      sum += set.sum();
    }
  }

  void listAlternatives(const std::vector<Explained>& others) {
    double sum = answer_.probability;
    for (const Explained& other : others) {
      if (sum >= kListed) {
        return;
      }
      if (isWorthListing(other.effects)) {
        answer_.alternatives.push_back(other);
      }
      sum += other.probability;
    }
  }

  const SetPosterior& posterior_;
  double sets_;  // probability of all sets together
  Answer answer_;
};

}  // namespace

Answer answer(const SetPosterior& posterior, std::size_t effects) {
  return Answering(toldByHalving(posterior), effects).run();
}

Answer answer(const ScoreTable& table, const JudgeNumbers& numbers) {
  return answer(setPosterior(table, numbers), table.effects.size());
}

Answer answer(const Evidence& evidence, const JudgeNumbers& numbers) { return answer(scoreTable(evidence), numbers); }

}  // namespace rubber_suspension::diagnosis::judge
