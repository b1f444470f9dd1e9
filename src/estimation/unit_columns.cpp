// One pass of a log: coefficients of the steps, branches of the friction, then block by block columns and products.
#include "unit_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension {
namespace {

constexpr std::size_t kColumnLanes = 8;    // sums that run side by side, on any processor
constexpr std::size_t kColumnBlock = 256;  // samples; a dozen columns stay in the first-level cache
constexpr std::size_t kColumnStride = kColumnBlock + kColumnLanes;  // branches write some samples more than asked for
constexpr std::size_t kTile = 3;  // columns on either side whose sums stay in registers
constexpr std::size_t kTileSums = kTile * kTile * kColumnLanes;

// Step of a Maxwell element of unit stiffness and what it changes by with ln(f_b).
struct RelaxationStep {
  double decay;
  double gain;  // [s]
  double decay_change;
  double gain_change;

  // x = dt/tau is proportional to f_b, and with it d exp(-x)/d ln x = -x exp(-x), d mean/d ln x = exp(-x) - mean.
  RelaxationStep(double dt, double break_frequency) {
    const double x = dt * 2.0 * M_PI * break_frequency;
    const Relaxation relaxation = Relaxation::over(x);
    decay = relaxation.decay;
    gain = relaxation.mean * dt;
    decay_change = -x * relaxation.decay;
    gain_change = (relaxation.decay - relaxation.mean) * dt;
  }
};

struct RelaxationState {
  double force = 0.0;
  double change = 0.0;
};

// A stretch of friction of unit maximum: force + way left/(reach + way), and the changes by ln(z2).
struct FrictionBranch {
  std::size_t end;  // sample after the last one
  double force;     // at the reference point
  double force_change;
  double left;  // to the maximum on this side
  double left_change;
  double reach;  // [m]
  double reach_change;

  FrictionBranch(std::size_t end_of_stretch, double reference_force, double reference_change, double side,
                 double displacement)
      : end(end_of_stretch),
        force(reference_force),
        force_change(reference_change),
        left(side - reference_force),
        left_change(-reference_change),
        reach(displacement * std::abs(left)),
        reach_change(reach + displacement * side * left_change) {}
};

// F+ = decay F + gain v of a Maxwell element, v being the rate of the displacement, and the derivative of that step by
// ln(f_b): all elements of a group side by side, so that none waits for its own last force alone.
template <std::size_t elements>
void relaxTogether(const RelaxationStep* step, RelaxationState* state, const double* rate, std::size_t count,
                   double* columns) {
  double force[elements];
  double change[elements];
  for (std::size_t k = 0; k < elements; ++k) {
    force[k] = state[k].force;
    change[k] = state[k].change;
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < elements; ++k) {
      change[k] = step[k].decay * change[k] + (step[k].decay_change * force[k] + step[k].gain_change * rate[i]);
      force[k] = step[k].decay * force[k] + step[k].gain * rate[i];
      columns[2 * k * kColumnStride + i] = force[k];
      columns[(2 * k + 1) * kColumnStride + i] = change[k];
    }
  }
  for (std::size_t k = 0; k < elements; ++k) {
    state[k] = {force[k], change[k]};
  }
}

// Forces of Maxwell elements of unit stiffness and their derivatives by ln(f_b), two columns for each.
void relax(const RelaxationStep* step, RelaxationState* state, std::size_t elements, const double* rate,
           std::size_t count, double* columns) {
  constexpr std::size_t kTogether = 3;
  for (; elements >= kTogether; elements -= kTogether) {
    relaxTogether<kTogether>(step, state, rate, count, columns);
    step += kTogether;
    state += kTogether;
    columns += 2 * kTogether * kColumnStride;
  }
  if (elements == 2) {
    relaxTogether<2>(step, state, rate, count, columns);
  } else if (elements == 1) {
    relaxTogether<1>(step, state, rate, count, columns);
  }
}

}  // namespace
}  // namespace rubber_suspension

#define RUBBER_SUSPENSION_KERNELS "../estimation/unit_column_kernels.h"
#include "../component/instruction_sets.h"

namespace rubber_suspension {
namespace {

std::size_t padded(std::size_t size) { return (size + kColumnLanes - 1) / kColumnLanes * kColumnLanes; }

double stepOf(const Measurement& measurement) {
  return static_cast<double>(measurement.stamp[1] - measurement.stamp[0]) * 1e-9;
}

AlignedNumbers rateOf(const Measurement& measurement) {
  AlignedNumbers rate(measurement.displacement.size(), 0.0);
  const double dt = stepOf(measurement);
  for (std::size_t i = 1; i < rate.size(); ++i) {
    rate[i] = (measurement.displacement[i] - measurement.displacement[i - 1]) / dt;
  }
  return rate;
}

// The branch that begins where another one is left.
FrictionBranch turned(const FrictionBranch& before, const FrictionStretch& stretch, double displacement) {
  const FrictionBranch towards(0, before.force, before.force_change, stretch.turning_side, displacement);
  const double inverse = 1.0 / (towards.reach + stretch.turning_way + std::numeric_limits<double>::min());
  const double part = stretch.turning_way * inverse;
  const double force = std::clamp(towards.force + part * towards.left, -1.0, 1.0);
  const double change =
      towards.force_change + part * (towards.left_change - towards.left * towards.reach_change * inverse);
  return {stretch.end, force, change, stretch.side, displacement};
}

std::vector<FrictionBranch> branchesOf(const FrictionPath& path, double displacement) {
  std::vector<FrictionBranch> branches;
  branches.reserve(path.stretches().size());
  FrictionBranch last(0, 0.0, 0.0, 1.0, displacement);
  for (const FrictionStretch& stretch : path.stretches()) {
    last = stretch.turns ? turned(last, stretch, displacement)
                         : FrictionBranch(stretch.end, last.force, last.force_change, stretch.side, displacement);
    branches.push_back(last);
  }
  return branches;
}

// The columns of one pass of a log: those of the laws, a block at a time.
class ColumnPass {
 public:
  ColumnPass(const EvenLog& log, const UnitColumnValues& values) : log_(log), state_(values.break_frequency.size()) {
    for (const double frequency : values.break_frequency) {
      step_.emplace_back(log.dt, frequency);
    }
    for (std::size_t k = 0; k < log.path.size(); ++k) {
      branches_.push_back(branchesOf(log.path[k], values.displacement[k]));
      branch_.push_back(branches_.back().data());
    }
    block_.resize((2 * (step_.size() + branches_.size()) + 1) * kColumnStride, 0.0);  // the last one stays zero
  }

  // Of the samples from `first` on; all blocks have to come in their order.
  void fill(std::size_t first, std::size_t count) {
    double* column = block_.data();
    const double* rate = log_.column[UnitColumns::kRate].data() + first;
    relax(step_.data(), state_.data(), step_.size(), rate, count, column);
    column += 2 * step_.size() * kColumnStride;
    for (std::size_t k = 0; k < branches_.size(); ++k) {
      branch_[k] =
          RUBBER_SUSPENSION_KERNEL(followBranches)(branch_[k], log_.path[k].way().data(), first, count, column);
      column += 2 * kColumnStride;
    }
    for (double* law = block_.data(); law < column; law += kColumnStride) {
      std::fill(law + count, law + padded(count), 0.0);
    }
  }

  // Where each column has its samples from `first` on, in whole tiles.
  std::vector<const double*> columns(std::size_t first, std::size_t tiles) const {
    std::vector<const double*> columns;
    for (const AlignedNumbers& fixed : log_.column) {
      columns.push_back(fixed.data() + first);
    }
    const double* const zeros = block_.data() + block_.size() - kColumnStride;
    for (const double* law = block_.data(); law < zeros; law += kColumnStride) {
      columns.push_back(law);
    }
    columns.resize(tiles * kTile, zeros);
    return columns;
  }

 private:
  const EvenLog& log_;
  std::vector<RelaxationStep> step_;
  std::vector<RelaxationState> state_;
  std::vector<std::vector<FrictionBranch>> branches_;
  std::vector<const FrictionBranch*> branch_;  // that the next sample is on
  AlignedNumbers block_;
};

EvenLog evenLog(const Measurement& measurement, const std::vector<double>& dead_bands) {
  EvenLog log;
  log.size = measurement.stamp.size();
  log.dt = stepOf(measurement);
  log.column.emplace_back(measurement.force.begin(), measurement.force.end());
  log.column.emplace_back(measurement.displacement.begin(), measurement.displacement.end());
  log.column.emplace_back(log.size, 1.0);
  log.column.push_back(rateOf(measurement));
  for (AlignedNumbers& column : log.column) {
    column.resize(padded(log.size), 0.0);
  }
  for (const double dead_band : dead_bands) {
    log.path.emplace_back(measurement.displacement, dead_band);
  }
  return log;
}

}  // namespace

bool UnitColumns::evenlySampled(const std::vector<Measurement>& measurements) {
  return std::all_of(measurements.begin(), measurements.end(), [](const Measurement& measurement) {
    const std::vector<std::int64_t>& stamp = measurement.stamp;
    for (std::size_t i = 2; i < stamp.size(); ++i) {
      if (stamp[i] - stamp[i - 1] != stamp[1] - stamp[0]) {
        return false;
      }
    }
    return true;
  });
}

UnitColumns::UnitColumns(const std::vector<Measurement>& measurements, std::size_t maxwells,
                         const std::vector<double>& dead_bands)
    : maxwells_(maxwells),
      frictions_(dead_bands.size()),
      tiles_((static_cast<std::size_t>(count()) + kTile - 1) / kTile),
      fixed_sums_(tiles_ * (tiles_ + 1) / 2 * kTileSums, 0.0) {
  for (const Measurement& measurement : measurements) {
    logs_.push_back(evenLog(measurement, dead_bands));
    const std::array<const double*, kTile> first = {logs_.back().column[0].data(), logs_.back().column[1].data(),
                                                    logs_.back().column[2].data()};
    RUBBER_SUSPENSION_KERNEL(addTile)(first.data(), first.data(), padded(logs_.back().size), fixed_sums_.data());
  }
}

Eigen::MatrixXd UnitColumns::products(const UnitColumnValues& values) const {
  std::vector<double> sums = fixed_sums_;
  for (const EvenLog& log : logs_) {
    ColumnPass pass(log, values);
    for (std::size_t first = 0; first < log.size; first += kColumnBlock) {
      const std::size_t size = std::min(kColumnBlock, log.size - first);
      pass.fill(first, size);
      RUBBER_SUSPENSION_KERNEL(addProducts)
      (pass.columns(first, tiles_).data(), tiles_, padded(size), sums.data());
    }
  }
  Eigen::MatrixXd products(count(), count());
  const double* sum = sums.data();
  const auto tile = static_cast<Eigen::Index>(kTile);
  for (Eigen::Index row = 0; row < count(); row += tile) {
    for (Eigen::Index column = row; column < static_cast<Eigen::Index>(tiles_) * tile; column += tile) {
      for (Eigen::Index k = 0; k < tile * tile; ++k, sum += kColumnLanes) {
        const Eigen::Index i = row + k / tile;
        const Eigen::Index j = column + k % tile;
        if (i < count() && j < count()) {
          products(i, j) = products(j, i) = std::accumulate(sum, sum + kColumnLanes, 0.0);
        }
      }
    }
  }
  return products;
}

Eigen::MatrixXd UnitColumns::combined(const UnitColumnValues& values, const Eigen::MatrixXd& weights) const {
  const std::size_t samples = std::accumulate(logs_.begin(), logs_.end(), std::size_t{0},
                                              [](std::size_t sum, const EvenLog& log) { return sum + log.size; });
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(samples), weights.cols());
  Eigen::Index row = 0;
  for (const EvenLog& log : logs_) {
    ColumnPass pass(log, values);
    for (std::size_t first = 0; first < log.size; first += kColumnBlock) {
      const std::size_t size = std::min(kColumnBlock, log.size - first);
      pass.fill(first, size);
      const std::vector<const double*> columns = pass.columns(first, tiles_);
      const auto rows = static_cast<Eigen::Index>(size);
      for (Eigen::Index k = 0; k < weights.cols(); ++k) {
        for (Eigen::Index i = 0; i < count(); ++i) {
          if (weights(i, k) != 0.0) {
            const Eigen::Map<const Eigen::VectorXd> column(columns[static_cast<std::size_t>(i)], rows);
            sums.col(k).segment(row, rows) += weights(i, k) * column;
          }
        }
      }
      row += rows;
    }
  }
  return sums;
}

}  // namespace rubber_suspension
