// The rows of a measured table of stiffness and loss angle as motions, and fits of hypotheses to them.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <optional>
#include <vector>

#include "fit/hypothesis_fitter.h"
#include "fit/hypothesis_forces.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/fit/measured_table.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::fit {

/// Represents each row by a record: a sine that grows from rest and settles, followed by one cycle that counts. Peaks
/// and area of this cycle give stiffness and loss angle, as in `estimate --from-table`.
class TableLoops {
 public:
  /// Throws std::invalid_argument like checkPoints().
  explicit TableLoops(std::vector<TablePoint> points);

  const std::vector<TablePoint>& points() const { return points_; }

  /// Returns the motions. The force of a record is an ellipse with the K* of its row and serves only as a scale.
  const std::shared_ptr<const std::vector<gap::PreparedRecord>>& records() const { return records_; }

  /// Returns K* of each row [N/m] from the forces on the records [N].
  std::vector<std::complex<double>> stiffness(const gap::Forces& forces) const;

  /// Returns K* of a component at each row [N/m].
  std::vector<std::complex<double>> stiffnessOf(const std::vector<element::ElementDescription>& elements) const;

  /// Returns the derivative of K* of a row for which `column` is the derivative of the force.
  std::complex<double> derivative(std::size_t row, const Eigen::VectorXd& force, const Eigen::VectorXd& column) const;

 private:
  std::vector<TablePoint> points_;
  std::shared_ptr<const std::vector<gap::PreparedRecord>> records_;
};

/// Fits hypotheses to one table. The residuals are (K* - K*_model)/|K*| of its rows, so that gaps are those of
/// gapOfTable(). The table counts as one log. Cross validation holds out rows as blocks, because rows are separate
/// tests; rows that are neighbours in frequency or amplitude are in different folds. Thread-safe once constructed; the
/// model has to outlive it.
class TableFitter final : public HypothesisFitter {
 public:
  /// `one_deviation`: gap that counts as much as a departure from prior knowledge by one standard deviation.
  TableFitter(std::shared_ptr<const TableLoops> loops, const ModelParameters& model, double one_deviation);

  const TableLoops& loops() const { return *loops_; }

  /// Returns K* of each row [N/m]; nullopt if the model parameters have no solution.
  std::optional<std::vector<std::complex<double>>> stiffness(const Hypothesis& hypothesis,
                                                             const ParameterVector& parameters) const;

 private:
  std::optional<gap::Forces> simulate(const Hypothesis& hypothesis, const ParameterVector& parameters) const override {
    return forces_.at(hypothesis, parameters);
  }
  double gapOf(const Hypothesis& hypothesis, const gap::Forces& forces) const override;
  std::vector<BlockGrams> normalEquationsAbout(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                               const gap::Forces& base, const Linearised& how) const override;

  std::shared_ptr<const TableLoops> loops_;
  HypothesisForces forces_;
  std::vector<int> fold_;  // fold of each row
};

}  // namespace rubber_suspension::fit
