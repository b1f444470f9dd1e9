// A hypothesis: the model's own parameters and the scales of some atoms, fitted jointly to the logs.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubber_suspension/diagnosis/candidate.h"
#include "rubber_suspension/diagnosis/own_parameters.h"
#include "rubber_suspension/diagnosis/record.h"

namespace rubber_suspension {

/// Force of a component over logs in the order of their recording on one specimen [N].
std::vector<Eigen::VectorXd> simulate(const std::vector<ElementDescription>& elements,
                                      const std::vector<Record>& records, bool raw_displacement = false);

/// Point of a fit: logarithms of the own parameters, then scales of the atoms.
struct Point {
  Eigen::VectorXd own;
  Eigen::VectorXd scales;
};

/// Normal equations of blocks of the logs, from which any fit that leaves blocks out follows at once. Columns: own
/// parameters, atoms, nuisance trends, and last the residual at the point of linearisation. Each log is weighted such
/// that residuals are in units of its force's standard deviation, and all logs count alike.
struct BlockGrams {
  std::vector<Eigen::MatrixXd> gram;
  std::vector<int> fold;
  std::vector<int> record;
  std::vector<double> weight;  ///< share of the block in all samples, weighted

  Eigen::MatrixXd sum(int without_fold = -1) const;
};

/// The fitted hypothesis.
struct Fit {
  Point point;
  double gap = 0.0;                  ///< RMS residual over force deviation, in sample
  double held_out = 0.0;             ///< the same on blocks that took no part in the fit, by cross validation
  std::vector<double> block_errors;  ///< mean square held-out residual of each block, in units of the force's variance
  std::vector<double> block_weights;
  std::vector<Eigen::VectorXd> residual;  ///< measured less simulated, per log [N]
};

/// Fits hypotheses to one set of logs. Thread-safe once constructed.
class Fitter {
 public:
  Fitter(std::vector<Record> records, const OwnParameters& own);

  const std::vector<Record>& records() const { return records_; }
  const OwnParameters& own() const { return own_; }

  /// Elements of a point; nothing where the own parameters have no solution.
  std::optional<std::vector<ElementDescription>> elements(const Point& point, const std::vector<Atom>& atoms) const;

  /// Residuals at a point and normal equations about it. Throws std::invalid_argument where the point has no model.
  /// Atoms that are not `active` get a column of zeros: they stay as they are. All are active where the list is empty.
  BlockGrams linearise(const Point& point, const std::vector<Atom>& atoms, bool trends,
                       const std::vector<bool>& active = {}) const;

  /// Fit by Gauss-Newton steps within the bounds, from a start. `trends`: a slow trend per log, which no model run
  /// reproduces, is free too (drift of the load cell that is not a ramp).
  Fit fit(const std::vector<Atom>& atoms, const Point& start, int iterations, bool trends = false) const;

  /// Simulate additive atoms once, so that every hypothesis that holds them may use their forces.
  void precompute(std::vector<Candidate>& candidates, int threads) const;

  /// Simulated forces at a point; nothing where the own parameters have no solution.
  std::optional<std::vector<Eigen::VectorXd>> forces(const Point& point, const std::vector<Atom>& atoms) const;

  /// The point of no change.
  Point configured(std::size_t atoms) const;

  /// RMS residual over force deviation at a point, without any fit.
  double gapAt(const Point& point, const std::vector<Atom>& atoms) const;

  /// Bounds on a step from a point: own parameters, atoms, trends.
  void stepBounds(const Point& point, const std::vector<Atom>& atoms, Eigen::Index columns, Eigen::VectorXd& lower,
                  Eigen::VectorXd& upper) const;

 private:
  using Columns = std::shared_ptr<const std::vector<Eigen::VectorXd>>;

  std::vector<Eigen::VectorXd> ownColumn(const Point& point, const std::vector<Atom>& atoms, Eigen::Index j,
                                         const std::vector<Eigen::VectorXd>& base) const;
  std::vector<Eigen::VectorXd> atomColumn(const Point& point, const std::vector<Atom>& atoms, std::size_t a,
                                          const std::vector<Eigen::VectorXd>& base) const;
  BlockGrams normalEquations(const std::vector<Eigen::VectorXd>& base, const std::vector<Columns>& columns,
                             bool trends) const;

  std::vector<Record> records_;
  const OwnParameters& own_;
  std::vector<double> weights_;  // per record: 1/(force deviation sqrt(samples records))
};

/// Held-out mean square error of each block, from its normal equations: each fold is predicted by a fit to the others.
std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

constexpr int kFolds = 4;

}  // namespace rubber_suspension
