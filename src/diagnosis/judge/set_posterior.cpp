// Converts weights of hypotheses to probabilities.
#include "diagnosis/judge/set_posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rubber_suspension::diagnosis::judge {

double SetPosterior::ofSets() const {
  return std::accumulate(sets.begin(), sets.end(), 0.0,
                         [](double sum, const SetProbability& set) { return sum + set.sum(); });
}

namespace {

std::vector<double> sizesInMotion(const ScoreTable& table, std::size_t hypothesis) {
  std::vector<double> sizes = table.sizes[hypothesis];
  for (std::size_t m = 0; m < sizes.size(); ++m) {
    if (table.constant[static_cast<std::size_t>(table.members[hypothesis][m])]) {
      sizes[m] = -std::numeric_limits<double>::infinity();
    }
  }
  return sizes;
}

void sortByProbability(std::vector<SetProbability>& sets) {
  std::stable_sort(sets.begin(), sets.end(),
                   [](const SetProbability& a, const SetProbability& b) { return a.sum() > b.sum(); });
}

}  // namespace

bool halvesWhatIsLeft(const ScoreTable& table, Eigen::Index hypothesis) {
  const auto square = [&](Eigen::Index row) { return (table.errors.row(row).transpose() * table.weight).sum(); };
  return table.left.row(hypothesis).isFinite().all() && square(hypothesis) <= 0.5 * square(Evidence::kReEstimated);
}

SetPosterior toldByHalving(SetPosterior posterior) {
  const auto share = [](const SetProbability& set) {
    return set.halves ? std::max(set.sum(), std::numeric_limits<double>::min()) : 0.0;
  };
  const double all = std::accumulate(posterior.sets.begin(), posterior.sets.end(), 0.0,
                                     [&](double sum, const SetProbability& set) { return sum + share(set); });
  if (all > 0.0) {
    const double rest = std::exchange(posterior.unknown, 0.0);
    for (SetProbability& set : posterior.sets) {
      set.beside += rest * (share(set) / all);
    }
    sortByProbability(posterior.sets);
  }
  return posterior;
}

SetPosterior setPosterior(const ScoreTable& table, const JudgeNumbers& numbers) {
  LogWeights weights = logWeights(table, numbers);
  const double most = std::max(weights.alone.maxCoeff(), weights.beside.maxCoeff());
  const auto overMost = [most](double logarithm) { return std::exp(logarithm - most); };  // 0 for minus infinity
  weights.alone = weights.alone.unaryExpr(overMost).eval();
  weights.beside = weights.beside.unaryExpr(overMost).eval();
  const double all = weights.alone.sum() + weights.beside.sum();
  weights.alone /= all;
  weights.beside /= all;

  SetPosterior posterior{weights.alone[Evidence::kAsConfigured],
                         weights.alone[Evidence::kReEstimated],
                         weights.beside[Evidence::kReEstimated],
                         {}};
  for (std::size_t h = Evidence::kFirstSingle; h < table.members.size(); ++h) {
    const auto row = static_cast<Eigen::Index>(h);
    posterior.sets.push_back({table.members[h], static_cast<int>(h), weights.alone[row], weights.beside[row],
                              sizesInMotion(table, h), halvesWhatIsLeft(table, row)});
  }
  sortByProbability(posterior.sets);
  return posterior;
}

}  // namespace rubber_suspension::diagnosis::judge
