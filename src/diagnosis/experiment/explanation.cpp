// Explanations that compete.
#include "diagnosis/experiment/explanation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr std::size_t kMost = 4;  // explanations compared: each has to be fitted to each motion of the menu

const FittedHypothesis* find(const Search& search, std::vector<int> members) {
  std::sort(members.begin(), members.end());
  const std::vector<const FittedHypothesis*> all = search.withEffects();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const FittedHypothesis* fitted) { return fitted->hypothesis.members == members; });
  return found == all.end() ? nullptr : *found;
}

// The best explanation that is not the one judged, of as many effects, or of one.
const FittedHypothesis* rivalOf(const Search& search, const FittedHypothesis& judged) {
  const std::vector<int>& members = judged.hypothesis.members;
  const FittedHypothesis* rival = nullptr;
  for (const auto* list : {&search.singles, &search.pairs}) {
    for (const FittedHypothesis& other : *list) {
      const std::size_t count = other.hypothesis.members.size();
      const bool counts = other.hypothesis.competes() && count == std::max<std::size_t>(1, members.size()) &&
                          other.hypothesis.members != members;
      if (counts && (rival == nullptr || other.fit.held_out < rival->fit.held_out)) {
        rival = &other;
      }
    }
  }
  return rival;
}

// With each other member of the largest set in the place of the one named.
std::vector<const FittedHypothesis*> othersOfSet(const Search& search, const Judgement& judgement,
                                                 const FittedHypothesis& judged) {
  std::size_t largest = 0;
  for (std::size_t i = 0; i < judgement.confounded.size(); ++i) {
    largest = judgement.confounded[i].size() > judgement.confounded[largest].size() ? i : largest;
  }
  std::vector<const FittedHypothesis*> others;
  if (largest < judgement.confounded.size() && largest < judgement.effects.size()) {
    const int named = judgement.effects[largest];
    for (const int other : judgement.confounded[largest]) {
      std::vector<int> members = judged.hypothesis.members;
      std::replace(members.begin(), members.end(), named, other);
      const FittedHypothesis* fitted = other == named ? nullptr : find(search, members);
      if (fitted != nullptr) {
        others.push_back(fitted);
      }
    }
  }
  return others;
}

}  // namespace

std::vector<double> probabilitiesOf(const std::vector<double>& left, double noise_floor, double gap,
                                    const Criteria& criteria) {
  const double blur = std::pow(criteria.noise_blur * noise_floor + criteria.gap_blur * gap, 2);
  std::vector<double> logarithms;
  for (const double rest : left) {
    const double above = gap::residualAboveFloor(rest, criteria.floor_margin * noise_floor);
    logarithms.push_back(-criteria.sharpness * std::log(above * above + blur));
  }
  const double largest = *std::max_element(logarithms.begin(), logarithms.end());
  std::vector<double> weights;
  for (const double logarithm : logarithms) {
    weights.push_back(std::exp(logarithm - largest));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) {
    weight /= sum;
  }
  return weights;
}

std::vector<Explanation> explanationsOf(const Search& search, const Judgement& judgement, const Criteria& criteria) {
  const FittedHypothesis& judged = search.at(judgement.model);
  std::vector<const FittedHypothesis*> chosen = othersOfSet(search, judgement, judged);
  if (judgement.values_would_do) {
    chosen.push_back(&search.re_estimated);
  }
  if (chosen.empty()) {
    if (const FittedHypothesis* rival = rivalOf(search, judged)) {
      chosen.push_back(rival);
    }
  }
  std::stable_sort(chosen.begin(), chosen.end(), [](const FittedHypothesis* x, const FittedHypothesis* y) {
    return x->fit.held_out < y->fit.held_out;
  });
  chosen.insert(chosen.begin(), &judged);
  chosen.resize(std::min(kMost, chosen.size()));
  std::vector<double> left;
  for (const FittedHypothesis* fitted : chosen) {
    left.push_back(std::isfinite(fitted->fit.held_out) ? fitted->fit.score() : 1e3);
  }
  const auto probabilities = probabilitiesOf(left, search.noise, search.re_estimated.fit.held_out, criteria);
  std::vector<Explanation> explanations;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    explanations.push_back({chosen[i], probabilities[i]});
  }
  return explanations;
}

std::string nameOf(const Search& search, const FittedHypothesis& fitted) {
  std::string text;
  for (const int member : fitted.hypothesis.members) {
    text += (text.empty() ? "" : " + ") + search.candidates[static_cast<std::size_t>(member)].effect;
  }
  return text.empty() ? "the model as it is" : text;
}

}  // namespace rubber_suspension::diagnosis
