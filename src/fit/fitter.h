// Fits of hypotheses to a set of logs.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fit/hypothesis_fitter.h"
#include "fit/hypothesis_forces.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Fits hypotheses to one set of logs. Thread-safe once constructed; the model has to outlive it.
class Fitter final : public HypothesisFitter {
 public:
  Fitter(std::shared_ptr<const std::vector<log::Record>> records, const ModelParameters& model);
  Fitter(std::vector<log::Record> records, const ModelParameters& model)
      : Fitter(std::make_shared<const std::vector<log::Record>>(std::move(records)), model) {}

  const std::vector<log::Record>& records() const { return forces_.records(); }
  const std::shared_ptr<const std::vector<log::Record>>& sharedRecords() const { return forces_.sharedRecords(); }
  const HypothesisForces& forces() const { return forces_; }
  const std::vector<double>& weights() const { return weights_; }

  /// Gap of these forces [N], without what is free in each log.
  double gapOf(FreeInLog free, const std::optional<std::vector<Eigen::VectorXd>>& simulated) const;

  double gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const override;

 private:
  BlockGrams normalEquationsAt(const Hypothesis& hypothesis, const ParameterVector& parameters, FreeInLog free,
                               const std::vector<bool>& active, int threads) const override;

  HypothesisForces forces_;
  std::vector<double> weights_;  // per record: sqrt(weight/(samples records))/(standard deviation of the force)
};

}  // namespace rubber_suspension::fit
