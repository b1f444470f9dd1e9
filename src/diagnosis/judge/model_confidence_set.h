// Which of many models may be the best, and how the evidence spreads over them.
#pragma once

#include <vector>

#include "diagnosis/judge/paired_losses.h"

namespace rubber_suspension::diagnosis {

/// Who is in the Model Confidence Set, and by what margin.
struct ModelConfidenceSet {
  std::vector<double> p_value;  ///< of each model; those of at least 1 - confidence are in the set
  std::vector<int> members;     ///< of the set at that confidence, best first
};

/// The models that may be the best at a confidence such as 0.9 (Hansen, Lunde and Nason, Econometrica 79, 2011, with
/// the statistic T_max): as long as the models left differ by more than chance the worst is taken out. The distribution
/// under equality comes from draws of clusters with random weights (Bayesian bootstrap), since a log is the unit that
/// repeats. `draws`, `seed`: of that resampling.
ModelConfidenceSet modelConfidenceSet(const Losses& losses, double confidence, int draws = 1000, unsigned seed = 1);

/// Weights of the models that add up to 1: pseudo-BMA+ (Yao, Vehtari, Simpson and Gelman, Bayesian Analysis 13, 2018).
/// A model's score is minus its mean loss times the number of clusters and `power`; scores are averaged over draws of
/// the clusters' weights from a Dirichlet distribution, so that few logs leave the weights apart less.
std::vector<double> pseudoBmaWeights(const Losses& losses, double power, int draws = 1000, unsigned seed = 1);

}  // namespace rubber_suspension::diagnosis
