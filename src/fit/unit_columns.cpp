// One pass of a log: coefficients of the steps, branches of the friction, then block by block columns and products.
#include "fit/unit_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "fit/tiles.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::fit {
namespace {

constexpr std::size_t kColumnBlock = 256;  // samples; a dozen columns stay in the first-level cache
constexpr std::size_t kColumnStride = kColumnBlock + kColumnLanes;  // branches write some samples more than asked for
constexpr std::size_t kMostSteps = 16;                              // lengths in a log

// Step of a Maxwell element of unit stiffness and what it changes by with ln(f_b).
struct RelaxationStep {
  double decay;
  double gain;  // [s]
  double decay_change;
  double gain_change;

  // x = dt/tau is proportional to f_b, and with it d exp(-x)/d ln x = -x exp(-x), d mean/d ln x = exp(-x) - mean.
  RelaxationStep(double dt, double break_frequency) {
    const double x = dt * 2.0 * element::kPi * break_frequency;
    const element::Relaxation relaxation = element::Relaxation::over(x);
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

// Steps of Maxwell elements for each step length of a log.
class RelaxationSteps {
 public:
  RelaxationSteps(const SteadyColumns& log, const std::vector<double>& break_frequency)
      : elements_(break_frequency.size()), one_(log.dt.size() == 1), which_(log.which.data()) {
    for (const double dt : log.dt) {
      for (const double frequency : break_frequency) {
        steps_.emplace_back(dt, frequency);
      }
    }
  }

  std::size_t elements() const { return elements_; }
  bool one() const { return one_; }
  // Those of all elements for the step to a sample.
  const RelaxationStep* at(std::size_t sample) const { return steps_.data() + which_[sample] * elements_; }

 private:
  std::size_t elements_;
  bool one_;
  const std::uint8_t* which_;
  std::vector<RelaxationStep> steps_;
};

// F+ = decay F + gain v of Maxwell elements, v being the rate of the displacement, and the derivatives of that step by
// ln(f_b): some elements from `first_element` on side by side, so that none waits for its own last force alone.
template <std::size_t elements, bool one_step>
void relaxTogether(const RelaxationSteps& steps, std::size_t first_element, RelaxationState* state, const double* rate,
                   std::size_t first, std::size_t count, double* columns) {
  double force[elements];
  double change[elements];
  for (std::size_t k = 0; k < elements; ++k) {
    force[k] = state[first_element + k].force;
    change[k] = state[first_element + k].change;
  }
  columns += 2 * first_element * kColumnStride;
  const RelaxationStep* step = steps.at(first) + first_element;
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (!one_step) {
      step = steps.at(first + i) + first_element;
    }
    for (std::size_t k = 0; k < elements; ++k) {
      change[k] = step[k].decay * change[k] + (step[k].decay_change * force[k] + step[k].gain_change * rate[i]);
      force[k] = step[k].decay * force[k] + step[k].gain * rate[i];
      columns[2 * k * kColumnStride + i] = force[k];
      columns[(2 * k + 1) * kColumnStride + i] = change[k];
    }
  }
  for (std::size_t k = 0; k < elements; ++k) {
    state[first_element + k] = {force[k], change[k]};
  }
}

// Forces of Maxwell elements of unit stiffness and their derivatives by ln(f_b), two columns for each, from sample
// `first` of the log on.
template <bool one_step>
void relax(const RelaxationSteps& steps, RelaxationState* state, const double* rate, std::size_t first,
           std::size_t count, double* columns) {
  constexpr std::size_t kTogether = 3;
  std::size_t k = 0;
  for (; k + kTogether <= steps.elements(); k += kTogether) {
    relaxTogether<kTogether, one_step>(steps, k, state, rate, first, count, columns);
  }
  if (k + 2 == steps.elements()) {
    relaxTogether<2, one_step>(steps, k, state, rate, first, count, columns);
  } else if (k + 1 == steps.elements()) {
    relaxTogether<1, one_step>(steps, k, state, rate, first, count, columns);
  }
}

}  // namespace
}  // namespace rubber_suspension::fit

#define RUBBER_SUSPENSION_LAYER fit
#define RUBBER_SUSPENSION_KERNELS "fit/unit_column_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::fit {
namespace {

std::size_t padded(std::size_t size) { return (size + kColumnLanes - 1) / kColumnLanes * kColumnLanes; }

// The different step lengths [ns] of a log, up to one more than are few.
std::vector<std::int64_t> stepLengths(const std::vector<std::int64_t>& stamp) {
  std::vector<std::int64_t> lengths;
  std::int64_t last = 0;
  for (std::size_t i = 1; i < stamp.size() && lengths.size() <= kMostSteps; ++i) {
    const std::int64_t length = stamp[i] - stamp[i - 1];
    if (length != last && std::find(lengths.begin(), lengths.end(), length) == lengths.end()) {
      lengths.push_back(length);
    }
    last = length;
  }
  return lengths;
}

// Step lengths and rates of the displacement.
void addSteps(const log::Log& recorded, SteadyColumns& log) {
  const std::vector<std::int64_t> lengths = stepLengths(recorded.stamp);
  for (const std::int64_t length : lengths) {
    log.dt.push_back(1e-9 * static_cast<double>(length));
  }
  log.which.resize(log.size, 0);
  AlignedNumbers rate(log.size, 0.0);
  for (std::size_t i = 1; i < log.size; ++i) {
    const std::int64_t length = recorded.stamp[i] - recorded.stamp[i - 1];
    log.which[i] = static_cast<std::uint8_t>(std::find(lengths.begin(), lengths.end(), length) - lengths.begin());
    rate[i] = (recorded.displacement[i] - recorded.displacement[i - 1]) / log.dt[log.which[i]];
  }
  log.column.push_back(std::move(rate));
}

// The branch that begins where another one is left.
FrictionBranch turned(const FrictionBranch& before, const FrictionStretch& stretch, double displacement) {
  const FrictionBranch towards(0, before.force, before.force_change, stretch.reversal_side, displacement);
  const double inverse = 1.0 / (towards.reach + stretch.reversal_travel + std::numeric_limits<double>::min());
  const double part = stretch.reversal_travel * inverse;
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
    last = stretch.reverses ? turned(last, stretch, displacement)
                            : FrictionBranch(stretch.end, last.force, last.force_change, stretch.side, displacement);
    branches.push_back(last);
  }
  return branches;
}

// The columns of one pass of a log: those of the laws, a block at a time.
class ColumnPass {
 public:
  ColumnPass(const SteadyColumns& log, const UnitColumnValues& values)
      : log_(log), steps_(log, values.break_frequency), state_(steps_.elements()) {
    for (std::size_t k = 0; k < log.path.size(); ++k) {
      branches_.push_back(branchesOf(log.path[k], values.displacement[k]));
      branch_.push_back(branches_.back().data());
    }
    block_.resize((2 * (steps_.elements() + branches_.size()) + 1) * kColumnStride, 0.0);  // the last one stays zero
  }

  // Of the samples from `first` on; all blocks have to come in their order.
  void fill(std::size_t first, std::size_t count) {
    double* column = block_.data();
    const double* rate = log_.column[UnitColumns::kRate].data() + first;
    (steps_.one() ? relax<true> : relax<false>)(steps_, state_.data(), rate, first, count, column);
    column += 2 * steps_.elements() * kColumnStride;
    for (std::size_t k = 0; k < branches_.size(); ++k) {
      branch_[k] =
          RUBBER_SUSPENSION_KERNEL(followBranches)(branch_[k], log_.path[k].travel().data(), first, count, column);
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
  const SteadyColumns& log_;
  RelaxationSteps steps_;
  std::vector<RelaxationState> state_;
  std::vector<std::vector<FrictionBranch>> branches_;
  std::vector<const FrictionBranch*> branch_;  // that the next sample is on
  AlignedNumbers block_;
};

SteadyColumns steadyColumns(const log::Log& recorded, const std::vector<double>& dead_bands) {
  SteadyColumns log;
  log.size = recorded.stamp.size();
  log.column.emplace_back(recorded.force.begin(), recorded.force.end());
  log.column.emplace_back(recorded.displacement.begin(), recorded.displacement.end());
  log.column.emplace_back(log.size, 1.0);
  addSteps(recorded, log);
  for (AlignedNumbers& column : log.column) {
    column.resize(padded(log.size), 0.0);
  }
  for (const double dead_band : dead_bands) {
    log.path.emplace_back(recorded.displacement, dead_band);
  }
  return log;
}

}  // namespace

bool UnitColumns::steady(const std::vector<log::Log>& logs) {
  return std::all_of(logs.begin(), logs.end(),
                     [](const log::Log& recorded) { return stepLengths(recorded.stamp).size() <= kMostSteps; });
}

UnitColumns::UnitColumns(const std::vector<log::Log>& logs, std::size_t maxwells, const std::vector<double>& dead_bands)
    : maxwells_(maxwells),
      frictions_(dead_bands.size()),
      tiles_((static_cast<std::size_t>(count()) + kTile - 1) / kTile),
      fixed_sums_(tiles_ * (tiles_ + 1) / 2 * kTileSums, 0.0) {
  for (const log::Log& recorded : logs) {
    logs_.push_back(steadyColumns(recorded, dead_bands));
    const std::array<const double*, kTile> first = {logs_.back().column[0].data(), logs_.back().column[1].data(),
                                                    logs_.back().column[2].data()};
    RUBBER_SUSPENSION_KERNEL(addTile)(first.data(), first.data(), padded(logs_.back().size), fixed_sums_.data());
  }
}

Eigen::MatrixXd UnitColumns::products(const UnitColumnValues& values) const {
  std::vector<double> sums = fixed_sums_;
  for (const SteadyColumns& log : logs_) {
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
                                              [](std::size_t sum, const SteadyColumns& log) { return sum + log.size; });
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(samples), weights.cols());
  Eigen::Index row = 0;
  for (const SteadyColumns& log : logs_) {
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

}  // namespace rubber_suspension::fit
