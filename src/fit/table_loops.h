// The rows of a table as motions, and K* of the forces on them.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/fit/measured_table.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Each row as a record: a sine that grows from rest over some cycles and settles, then one cycle that counts. Of that
/// cycle stiffness and loss angle are those of the whole loop, by peaks and area, as `estimate --from-table` takes
/// them.
class TableLoops {
 public:
  /// Throws std::invalid_argument as checkPoints() does.
  explicit TableLoops(std::vector<TablePoint> points);

  const std::vector<TablePoint>& points() const { return points_; }

  /// The motions. The force of a record is that of an ellipse with the K* of its row, for sizes and scales alone.
  const std::shared_ptr<const std::vector<log::Record>>& records() const { return records_; }

  /// K* of each row [N/m] by the forces on the records [N].
  std::vector<std::complex<double>> stiffness(const std::vector<Eigen::VectorXd>& forces) const;

  /// The same of a component.
  std::vector<std::complex<double>> stiffnessOf(const std::vector<element::ElementDescription>& elements) const;

  /// Derivative of K* of a row where its force has the derivative `column`.
  std::complex<double> derivative(std::size_t row, const Eigen::VectorXd& force, const Eigen::VectorXd& column) const;

 private:
  std::vector<TablePoint> points_;
  std::shared_ptr<const std::vector<log::Record>> records_;
};

}  // namespace rubber_suspension::fit
