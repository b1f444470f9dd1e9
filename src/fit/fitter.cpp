// Residuals of logs and their normal equations.
#include "fit/fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fit/parallel.h"

namespace rubber_suspension::fit {
Fitter::Fitter(std::shared_ptr<const std::vector<log::Record>> records, const ModelParameters& model)
    : HypothesisFitter(model), forces_(std::move(records), model) {
  const auto count = static_cast<double>(this->records().size());
  double noise = 0.0;
  for (const log::Record& record : this->records()) {
    weights_.push_back(std::sqrt(record.weight / (record.counted() * count)) / record.force_deviation);
    noise += record.weight * std::max(gap::whiteNoiseFloor(record, record.force), kLeastNoise) / count;
  }
  setNoise(noise);
}

double Fitter::gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  return gapOf(hypothesis.free_in_log, forces_.at(hypothesis, parameters));
}

double Fitter::gapOf(FreeInLog free, const std::optional<std::vector<Eigen::VectorXd>>& simulated) const {
  if (!simulated) {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (std::size_t r = 0; r < records().size(); ++r) {
    const log::Record& record = records()[r];
    const Eigen::VectorXd residual = record.withoutRig(record.force - (*simulated)[r]);
    double square = residual.squaredNorm();
    if (free.gain) {
      const Eigen::VectorXd force = record.withoutRig((*simulated)[r]);
      const double norm = force.squaredNorm();
      square -= norm > 0.0 ? std::pow(force.dot(residual), 2) / norm : 0.0;
    }
    sum += std::pow(weights_[r], 2) * square;
  }
  return std::isfinite(sum) ? std::sqrt(sum) : std::numeric_limits<double>::infinity();
}

BlockGrams Fitter::normalEquationsAt(const Hypothesis& hypothesis, const ParameterVector& parameters, FreeInLog free,
                                     const std::vector<bool>& active, int threads) const {
  const auto base = forces_.at(hypothesis, parameters);
  if (!base) {
    throw std::invalid_argument("the model has no solution at the parameters to be linearised about");
  }
  return normalEquations(records(), weights_, *base, forces_.columns(hypothesis, parameters, active, *base, threads),
                         free, threads);
}

}  // namespace rubber_suspension::fit
