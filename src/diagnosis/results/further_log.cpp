// Predicts each log by a fit to the other logs.
#include "diagnosis/results/further_log.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "diagnosis/results/replayed.h"
#include "fit/parallel.h"
#include "gap/simulate.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr std::size_t kFewestToLeaveOneOut = 3;
constexpr int kWarmSteps = 3;  // iterations of a fit that starts from the fit to all logs

fit::ForceColumn without(const fit::ForceColumn& column, std::size_t log) {
  return column ? std::make_shared<const fit::StoredForces>(column->without(log)) : nullptr;
}

Entries fittedWithout(const hypotheses::PreparedCase& prepared, const FittedLaw& fitted, std::size_t log) {
  std::vector<gap::PreparedRecord> remaining = prepared.training;
  remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(log));
  const fit::Fitter fitter(std::move(remaining), prepared.model, prepared.fitter.oneDeviation());
  fit::Hypothesis hypothesis = fitted.law.hypothesis();
  hypothesis.free_in_log.by_zero = without(hypothesis.free_in_log.by_zero, log);
  hypothesis.free_in_log.by_factor = without(hypothesis.free_in_log.by_factor, log);
  for (fit::BasisTerm& term : hypothesis.terms) {
    term.unit_effect = without(term.unit_effect, log);
  }
  FittedLaw others = fitted;
  others.fit = fitter.fit(hypothesis, fitted.fit.parameters, {kWarmSteps});
  return elementsOf(prepared.model, others);
}

double squaredGap(const gap::PreparedRecord& record, const Entries& elements) {
  const Eigen::VectorXd counts = record.counts.size() > 0 ? record.counts : Eigen::VectorXd::Ones(record.size());
  const Eigen::VectorXd residual = record.force - gap::simulateEach(elements, {record}).front();
  const double offset = residual.dot(counts) / record.counted();
  return (residual.array() - offset).square().matrix().dot(counts) / record.counted() /
         std::pow(record.force_deviation, 2);
}

}  // namespace

double gapOfFurtherLog(const hypotheses::PreparedCase& prepared, const FittedLaw* fitted, int threads) {
  const std::vector<gap::PreparedRecord>& logs = prepared.training;
  if (logs.size() < kFewestToLeaveOneOut || !prepared.held_out.empty()) {
    return kNotComputed;
  }
  std::vector<double> squares(logs.size());
  fit::parallelFor(logs.size(), threads, [&](std::size_t log) {
    squares[log] = squaredGap(
        logs[log], fitted == nullptr ? prepared.component.allElements() : fittedWithout(prepared, *fitted, log));
  });
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(logs.size()));
}

}  // namespace rubber_suspension::diagnosis::results
