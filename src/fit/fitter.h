// Fits of hypotheses to a set of logs.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fit/hypothesis_fitter.h"
#include "fit/hypothesis_forces.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::fit {

/// Fits hypotheses to one set of logs. Thread-safe once constructed; the model has to outlive it.
class Fitter final : public HypothesisFitter {
 public:
  /// `one_deviation`: gap that counts as much as a departure from prior knowledge by one standard deviation.
  Fitter(std::shared_ptr<const std::vector<gap::PreparedRecord>> records, const ModelParameters& model,
         double one_deviation);
  Fitter(std::vector<gap::PreparedRecord> records, const ModelParameters& model, double one_deviation)
      : Fitter(std::make_shared<const std::vector<gap::PreparedRecord>>(std::move(records)), model, one_deviation) {}

  const std::vector<gap::PreparedRecord>& records() const { return forces_.records(); }
  const HypothesisForces& forces() const { return forces_; }
  const LogBlocks& blocks() const { return *blocks_; }
  double gapOf(const Hypothesis& hypothesis, const gap::Forces& forces) const override;

  /// Finds unit effects of the candidates (findUnitEffects()) and their products, so that fits need not compute them,
  /// and sets BasisTerm::depends_on_place. No fit may run at the same time.
  void prepare(std::vector<Candidate>& candidates, int threads);

  /// Adds a displacement offset of each log to the parameters of the fit if the force of the hypothesis depends on it
  /// and the tolerance of the rig is known.
  void freeZeros(const ParameterVector& parameters, Hypothesis& hypothesis) const override;

  void freeFactors(const ParameterVector& parameters, Hypothesis& hypothesis) const override;

  /// Returns the factor on the friction of each log at a parameter vector; empty if the factors are not fitted.
  std::vector<double> factors(Hypothesis hypothesis, const ParameterVector& parameters) const;

 private:
  std::optional<gap::Forces> simulate(const Hypothesis& hypothesis, const ParameterVector& parameters) const override {
    return forces_.at(hypothesis, parameters);
  }
  std::vector<BlockGrams> normalEquationsAbout(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                               const gap::Forces& base, const Linearised& how) const override {
    return blocks_->normalEquations(base, forces_.columns(hypothesis, parameters, how.active, base, how.threads),
                                    how.free, how.kept, how.threads);
  }
  /// Estimated nuisance parameters of a log, and the part of the squared residual that they explain.
  struct Own {
    Eigen::VectorXd values;
    double taken = 0.0;
  };
  Own ownOf(const PerLogNuisances& free, std::size_t r, const Eigen::VectorXd& simulated,
            const Eigen::VectorXd& residual) const;

  HypothesisForces forces_;
  std::unique_ptr<const LogBlocks> blocks_;
  bool model_depends_on_place_ = false;
};

}  // namespace rubber_suspension::fit
