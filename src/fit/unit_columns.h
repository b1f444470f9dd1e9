// Products of all columns that a linear combination of springs, dashpots, Maxwell elements and Berg friction is made
// of, in one pass of the logs: block by block, so that no column is ever kept whole.
#pragma once

#include <Eigen/Core>
#include <boost/align/aligned_allocator.hpp>
#include <cstdint>
#include <vector>

#include "fit/friction_path.h"
#include "rubber_suspension/fit/identification.h"

namespace rubber_suspension::fit {

/// The parameters that the laws of the columns depend on nonlinearly.
struct UnitColumnValues {
  std::vector<double> break_frequency;  ///< of each Maxwell element [Hz]
  std::vector<double> displacement;     ///< z2 of each friction [m]
};

/// Numbers that vectors of eight are read from: these begin at a line of the cache.
using AlignedNumbers = std::vector<double, boost::alignment::aligned_allocator<double, 64>>;

/// Columns of a log whose steps have few lengths: of constant rate, but for stamps that are rounded, and time gaps.
struct SteadyColumns {
  std::size_t size;
  std::vector<double> dt;              // different step lengths [s]
  std::vector<std::uint8_t> which;     // of these the step to each sample has
  std::vector<AlignedNumbers> column;  // those of UnitColumns::Fixed; zeros follow for a multiple of eight samples
  std::vector<FrictionPath> path;      // of each friction
};

/// Columns over steady logs, each component at rest at its first sample: measured force, displacement, ones,
/// rate of the displacement; then for each Maxwell element the force at unit stiffness and its derivative by ln(f_b);
/// then for each Berg friction the force at unit maximum and its derivative by ln(z2).
///
/// The laws are those of Maxwell::step and BergFriction::branch; what they remember, and the derivative of it,
/// continues from sample to sample.
class UnitColumns {
 public:
  enum Fixed : Eigen::Index { kForce, kDisplacement, kOne, kRate, kFirstLaw };

  /// Whether each log has sixteen step lengths at most.
  static bool steady(const std::vector<log::Log>& logs);

  /// For steady logs; dead bands [m] of the frictions.
  UnitColumns(const std::vector<log::Log>& logs, std::size_t maxwells, const std::vector<double>& dead_bands);

  static Eigen::Index maxwell(std::size_t k) { return kFirstLaw + 2 * static_cast<Eigen::Index>(k); }
  Eigen::Index friction(std::size_t k) const { return maxwell(maxwells_ + k); }
  Eigen::Index count() const { return maxwell(maxwells_ + frictions_); }
  /// Rounding of a product of two columns, relative to the product of their lengths.
  static double rounding() { return 1e-15; }

  /// Products of each column with each; the same bits on any processor.
  Eigen::MatrixXd products(const UnitColumnValues& values) const;

  /// Linear combinations of the columns, one for each column of `weights`; a row for each sample of all logs.
  Eigen::MatrixXd combined(const UnitColumnValues& values, const Eigen::MatrixXd& weights) const;

 private:
  std::size_t maxwells_;
  std::size_t frictions_;
  std::size_t tiles_;  // of columns
  std::vector<SteadyColumns> logs_;
  std::vector<double> fixed_sums_;  // those of the tiles, where no law has a part
};

}  // namespace rubber_suspension::fit
