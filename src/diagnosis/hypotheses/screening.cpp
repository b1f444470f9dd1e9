// Screens hypotheses by means of normal equations.
#include "diagnosis/hypotheses/screening.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "element/each.h"
#include "fit/parallel.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

// Shares of the force and of the noise that a testable candidate of typical size leaves after re-estimation.
constexpr double kVisibleShare = 0.05;
constexpr double kVisibleSize = 0.2;

std::vector<int> allOf(const std::vector<fit::Candidate>& candidates) {
  std::vector<int> members(candidates.size());
  std::iota(members.begin(), members.end(), 0);
  return members;
}

}  // namespace

Screening::Screening(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
                     const FittedHypothesis& about, int threads)
    : candidates_(candidates),
      model_size_(fitter.model().size()),
      threads_(threads),
      all_(fit::makeHypothesis(candidates, allOf(candidates), {}, about.hypothesis.curved)) {
  about_ = fitter.configured(all_);
  about_.model = about.fit.parameters.model;
  Eigen::Index fitted = 0;
  for (const Eigen::Index column : columnsOf(about.hypothesis)) {
    about_.scales[column - model_size_] = about.fit.parameters.scales[fitted++];
  }
  std::vector<fit::PerLogNuisances> free;
  for (const bool gain : {false, true}) {
    for (const bool offset : {false, true}) {
      for (const bool trend : {false, true}) {
        free.push_back({trend, offset, gain, nullptr, about.hypothesis.free_in_log.by_factor});
      }
    }
  }
  blocks_ = fitter.lineariseFolds(all_, about_, free, threads);
  bounds_ = fitter.stepBounds(all_, about_, blocks().unknowns());
  preferLawsAtWork(about.hypothesis);
  for (const int candidate : allOf(candidates)) {
    columns_of_.push_back(columnsOf(hypothesisOf({candidate})));
  }
}

void Screening::preferLawsAtWork(const fit::Hypothesis& about) {
  std::vector<std::pair<double, int>> contained;
  for (const int candidate : allOf(candidates_)) {
    const bool any = std::any_of(candidates_.begin(), candidates_.end(), [&](const fit::Candidate& larger) {
      return fit::contains(larger, candidates_[static_cast<std::size_t>(candidate)]);
    });
    if (any) {
      contained.emplace_back(leftBy({candidate}), candidate);
    }
  }
  std::sort(contained.begin(), contained.end());
  preferred_ = about.members;
  preferred_.insert(preferred_.end(), about.held.begin(), about.held.end());
  for (const auto& [left, candidate] : contained) {
    preferred_.push_back(candidate);
  }
}

fit::Hypothesis Screening::hypothesisOf(const std::vector<int>& members) const {
  return fit::makeHypothesis(candidates_, members, preferred_, all_.curved);
}

std::vector<Eigen::Index> Screening::columnsOf(const fit::Hypothesis& hypothesis) const {
  return element::each(hypothesis.places, [&](const fit::TermPlace& place) {
    return model_size_ + (std::find(all_.places.begin(), all_.places.end(), place) - all_.places.begin());
  });
}

Screening::Part Screening::partOf(const std::vector<int>& members) const {
  Part part;
  part.columns.resize(static_cast<std::size_t>(model_size_));
  std::iota(part.columns.begin(), part.columns.end(), 0);
  const fit::Hypothesis hypothesis = hypothesisOf(members);
  const std::vector<Eigen::Index> terms = columnsOf(hypothesis);
  part.columns.insert(part.columns.end(), terms.begin(), terms.end());
  part.free = hypothesis.free_in_log;
  part.bounds = {bounds_.lower(part.columns), bounds_.upper(part.columns)};
  return part;
}

Screened Screening::screen(std::vector<int> members) const {
  std::sort(members.begin(), members.end());
  const Part part = partOf(members);
  const fit::BlockGrams folds = blocks(part.free).of(part.columns);
  const std::vector<double> errors =
      fit::crossValidate(folds, [&](const Eigen::MatrixXd& gram) { return fit::solve(gram, part.bounds); });
  return {members, std::sqrt(std::inner_product(errors.begin(), errors.end(), folds.weight.begin(), 0.0))};
}

double Screening::leftBy(const std::vector<int>& members) const {
  const Part part = partOf(members);
  const Eigen::MatrixXd gram = fit::ofUnknowns(blocks(part.free).sum, part.columns);
  return std::sqrt(std::max(0.0, fit::squaresLeft(gram, fit::solve(gram, part.bounds))));
}

// The change of the model parameters is limited to that of one step of a fit, because the force is not linear in them.
fit::ParameterVector Screening::bestOf(const std::vector<int>& members) const {
  Part part = partOf(members);
  auto lower = part.bounds.lower.head(model_size_);
  auto upper = part.bounds.upper.head(model_size_);
  lower = lower.cwiseMax(-fit::kLongestStep);
  upper = upper.cwiseMin(fit::kLongestStep);
  const Eigen::VectorXd step = fit::solve(fit::ofUnknowns(blocks(part.free).sum, part.columns), part.bounds);
  fit::ParameterVector best{about_.model + step.head(model_size_), {}};
  best.scales.resize(0);
  std::vector<double> scales;
  for (std::size_t i = static_cast<std::size_t>(model_size_); i < part.columns.size(); ++i) {
    const Eigen::Index term = part.columns[i] - model_size_;
    const fit::BasisTerm& info = all_.terms[static_cast<std::size_t>(term)];
    scales.push_back(std::clamp(about_.scales[term] + step[static_cast<Eigen::Index>(i)], info.lower, info.upper));
  }
  best.scales = Eigen::Map<const Eigen::VectorXd>(scales.data(), static_cast<Eigen::Index>(scales.size()));
  return best;
}

bool Screening::joins(int candidate, const std::vector<int>& members) const {
  return std::none_of(members.begin(), members.end(), [&](int member) {
    return fit::holds(candidates_, {member}, {candidate}) || fit::holds(candidates_, {candidate}, {member});
  });
}

std::vector<Screened> Screening::additions(const std::vector<int>& candidates, const std::vector<int>& members) const {
  std::vector<std::vector<int>> sets;
  for (const int c : candidates) {
    if (joins(c, members)) {
      sets.push_back(members);
      sets.back().push_back(c);
    }
  }
  return screenAll(sets);
}

std::vector<Screened> Screening::withContained(const std::vector<int>& candidates, const std::vector<int>& members,
                                               std::size_t effects) const {
  std::vector<std::vector<int>> sets;
  for (const int member : members) {
    std::vector<int> set = members;
    set.erase(std::find(set.begin(), set.end(), member));
    for (const int c : candidates) {
      if (fit::contains(candidates_[static_cast<std::size_t>(member)], candidates_[static_cast<std::size_t>(c)]) &&
          joins(c, set)) {
        set.push_back(c);
      }
    }
    if (set.size() == effects && set.size() >= members.size()) {
      sets.push_back(std::move(set));
    }
  }
  return screenAll(sets);
}

std::vector<Screened> Screening::pairs(const std::vector<int>& candidates) const {
  std::vector<std::vector<int>> sets;
  for (auto a = candidates.begin(); a != candidates.end(); ++a) {
    for (auto b = a + 1; b != candidates.end(); ++b) {
      if (joins(*b, {*a})) {
        sets.push_back({*a, *b});
      }
    }
  }
  return screenAll(sets);
}

std::vector<Visibility> Screening::visibility(double noise) const {
  std::vector<Visibility> result;
  const Eigen::MatrixXd total = blocks().sum - blocks().prior;
  const Eigen::MatrixXd base = total.topLeftCorner(model_size_, model_size_);
  for (const auto& columns : columns_of_) {
    Visibility& candidate = result.emplace_back();
    for (const Eigen::Index j : columns) {
      const Eigen::VectorXd cross = total.col(j).head(model_size_);
      const double whole = blocks().squares[j];
      const double rest = std::max(0.0, whole - cross.dot(numerics::solveLeastNorm(base, cross)));
      const double visible = whole > 0.0 ? std::sqrt(rest / whole) : 0.0;
      candidate.share = std::max(candidate.share, visible);
      const double size = all_.terms[static_cast<std::size_t>(j - model_size_)].typical * std::sqrt(rest);
      candidate.testable = candidate.testable || (visible >= kVisibleShare && size >= kVisibleSize * noise);
    }
  }
  return result;
}

// Sorts sets by their error on the blocks of the fit, then the best of them by their error on held-out blocks.
std::vector<Screened> Screening::screenAll(const std::vector<std::vector<int>>& sets) const {
  constexpr std::size_t kHeldOut = 16;
  std::vector<Screened> result(sets.size());
  fit::parallelFor(sets.size(), threads_, [&](std::size_t i) { result[i] = {sets[i], leftBy(sets[i])}; });
  const auto by_error = [](const Screened& x, const Screened& y) { return x.error < y.error; };
  std::stable_sort(result.begin(), result.end(), by_error);
  result.resize(std::min(kHeldOut, result.size()));
  fit::parallelFor(result.size(), threads_, [&](std::size_t i) { result[i] = screen(result[i].members); });
  std::stable_sort(result.begin(), result.end(), by_error);
  return result;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
