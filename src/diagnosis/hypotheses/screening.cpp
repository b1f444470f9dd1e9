// Screening of hypotheses by normal equations.
#include "diagnosis/hypotheses/screening.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/parallel.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::diagnosis {
namespace {

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
      all_(fit::makeHypothesis(candidates, allOf(candidates))) {
  all_.free_in_log = {true, true};
  Eigen::Index column = model_size_;
  for (const fit::Candidate& candidate : candidates) {
    columns_of_.emplace_back(candidate.terms.size());
    std::iota(columns_of_.back().begin(), columns_of_.back().end(), column);
    column += static_cast<Eigen::Index>(candidate.terms.size());
  }
  fit::ParameterVector parameters = fitter.configured(all_);
  parameters.model = about.fit.parameters.model;
  Eigen::Index fitted = 0;
  for (const int member : about.hypothesis.members) {
    for (const Eigen::Index of_member : columns_of_[static_cast<std::size_t>(member)]) {
      parameters.scales[of_member - model_size_] = about.fit.parameters.scales[fitted++];
    }
  }
  blocks_ = fitter.linearise(all_, parameters, {}, threads);
  fitter.stepBounds(all_, parameters, unknowns(), lower_, upper_);
}

Screened Screening::screen(std::vector<int> members) const {
  std::sort(members.begin(), members.end());
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(model_size_));
  std::iota(columns.begin(), columns.end(), 0);
  fit::FreeInLog free;
  for (const int member : members) {
    const auto& more = columns_of_[static_cast<std::size_t>(member)];
    columns.insert(columns.end(), more.begin(), more.end());
    free = free | candidates_[static_cast<std::size_t>(member)].free_in_log;
  }
  const std::vector<Eigen::Index> in_log = freeColumns(free);
  columns.insert(columns.end(), in_log.begin(), in_log.end());
  Eigen::VectorXd lower(static_cast<Eigen::Index>(columns.size()));
  Eigen::VectorXd upper(lower.size());
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    lower[i] = lower_[columns[static_cast<std::size_t>(i)]];
    upper[i] = upper_[columns[static_cast<std::size_t>(i)]];
  }
  const std::vector<double> errors = fit::crossValidate(blocks_, columns, lower, upper);
  return {members, std::sqrt(std::inner_product(errors.begin(), errors.end(), blocks_.weight.begin(), 0.0))};
}

std::vector<Eigen::Index> Screening::freeColumns(fit::FreeInLog free) const {
  std::vector<Eigen::Index> columns;
  const Eigen::Index first = model_size_ + static_cast<Eigen::Index>(all_.terms.size());
  const Eigen::Index of_log = all_.free_in_log.count();
  for (Eigen::Index j = first; j < unknowns(); ++j) {
    const bool is_gain = (j - first) % of_log == of_log - 1;
    if (is_gain ? free.gain : free.trend) {
      columns.push_back(j);
    }
  }
  return columns;
}

bool Screening::mayJoin(int candidate, Joining joining) const {
  const fit::Candidate& other = candidates_[static_cast<std::size_t>(candidate)];
  return other.competes() && other.last_resort == (joining == Joining::last_resorts);
}

std::vector<Screened> Screening::additions(const std::vector<int>& members, Joining joining) const {
  std::vector<std::vector<int>> sets;
  for (int c = 0; c < static_cast<int>(candidates_.size()); ++c) {
    if (mayJoin(c, joining) && std::find(members.begin(), members.end(), c) == members.end()) {
      sets.push_back(members);
      sets.back().push_back(c);
    }
  }
  return screenAll(sets);
}

std::vector<Screened> Screening::pairs() const {
  std::vector<std::vector<int>> sets;
  const int count = static_cast<int>(candidates_.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (mayJoin(a) && mayJoin(b)) {
        sets.push_back({a, b});
      }
    }
  }
  return screenAll(sets);
}

void Screening::measureVisibility(double noise, const Criteria& criteria, Search& result) const {
  const Eigen::MatrixXd total = blocks_.sum - blocks_.prior;
  const Eigen::MatrixXd base = total.topLeftCorner(model_size_, model_size_);
  for (const auto& columns : columns_of_) {
    double share = 0.0;
    bool testable = false;
    for (const Eigen::Index j : columns) {
      const Eigen::VectorXd cross = total.col(j).head(model_size_);
      const double whole = total(j, j);
      const double rest = std::max(0.0, whole - cross.dot(numerics::solveLeastNorm(base, cross)));
      const double visible = whole > 0.0 ? std::sqrt(rest / whole) : 0.0;
      share = std::max(share, visible);
      const double size = all_.terms[static_cast<std::size_t>(j - model_size_)].typical * std::sqrt(rest);
      testable = testable || (visible >= criteria.visible_share && size >= criteria.visible_size * noise);
    }
    result.visible_share.push_back(share);
    result.testable.push_back(testable);
  }
}

// Best first.
std::vector<Screened> Screening::screenAll(const std::vector<std::vector<int>>& sets) const {
  std::vector<Screened> result(sets.size());
  fit::parallelFor(sets.size(), threads_, [&](std::size_t i) { result[i] = screen(sets[i]); });
  std::stable_sort(result.begin(), result.end(),
                   [](const Screened& x, const Screened& y) { return x.error < y.error; });
  return result;
}

}  // namespace rubber_suspension::diagnosis
