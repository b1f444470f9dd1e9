// Fits of hypotheses to a measured table of stiffness and loss angle.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <vector>

#include "fit/hypothesis_fitter.h"
#include "fit/hypothesis_forces.h"
#include "fit/table_loops.h"

namespace rubber_suspension::fit {

/// Fits hypotheses to one table: residuals are (K* - K*_model)/|K*| of its rows, so that gaps are those of
/// gapOfTable(). A table counts as one log, and each row as a block of it that cross validation leaves out: rows are
/// tests of their own. Neighbours on the grid of frequency and amplitude are in different folds. Thread-safe once
/// constructed; the model has to outlive it.
class TableFitter final : public HypothesisFitter {
 public:
  /// `noise`: of K*, relative, from which the penalty of changed model parameters follows.
  TableFitter(std::shared_ptr<const TableLoops> loops, const ModelParameters& model, double noise);

  const TableLoops& loops() const { return *loops_; }

  /// K* of each row [N/m]; nothing where the model parameters have no solution.
  std::optional<std::vector<std::complex<double>>> stiffness(const Hypothesis& hypothesis,
                                                             const ParameterVector& parameters) const;

 private:
  using Forces = std::vector<Eigen::VectorXd>;
  std::optional<Forces> simulate(const Hypothesis& hypothesis, const ParameterVector& parameters) const override {
    return forces_.at(hypothesis, parameters);
  }
  double gapOf(const Hypothesis& hypothesis, const Forces& forces) const override;
  BlockGrams normalEquationsAbout(const Hypothesis& hypothesis, const ParameterVector& parameters, const Forces& base,
                                  FreeInLog free, const std::vector<bool>& active, int threads) const override;

  std::shared_ptr<const TableLoops> loops_;
  HypothesisForces forces_;
  std::vector<int> fold_;  // of each row
};

}  // namespace rubber_suspension::fit
