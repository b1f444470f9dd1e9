// The explanations of the same logs between which an experiment is to decide.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/judge.h"

namespace rubber_suspension::diagnosis {

/// A fitted hypothesis and how probable it is among those to decide between.
struct Explanation {
  const FittedHypothesis* fitted = nullptr;
  double probability = 0.0;
};

/// The hypothesis judged and, of the largest set that cannot be told apart, those with another member in its place,
/// wrong values among them; the best other one where no set has two members. The one judged comes first, then by
/// probability. One alone where there is no other.
std::vector<Explanation> explanationsOf(const Search& search, const Judgement& judgement, const Criteria& criteria);

/// Probabilities of explanations by what each leaves (a gap), by the law of the judgement: a power of what is left
/// above the floor, blurred by what cannot be told apart. `gap`: what a model without effects leaves.
std::vector<double> probabilitiesOf(const std::vector<double>& left, double noise_floor, double gap,
                                    const Criteria& criteria);

/// "friction + creep"; "the model as it is" without members.
std::string nameOf(const Search& search, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis
