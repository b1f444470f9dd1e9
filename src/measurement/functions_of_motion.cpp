// Piecewise linear functions of displacement and speed.
#include "measurement/functions_of_motion.h"

#include <algorithm>
#include <array>
#include <utility>

#include "measurement/statistics.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Piecewise linear hat functions, evenly spaced over the range of a signal. At each value two of them differ from 0.
class Hats {
 public:
  Hats(const VectorXd& signal, Index count)
      : low_(signal.minCoeff()), step_(rangeOf(signal) / static_cast<double>(count - 1)) {}

  // Returns the index of the first function that differs from 0 at `value`, and the value of the next function.
  std::pair<Index, double> at(double value) const {
    const double place = step_ > 0.0 ? (value - low_) / step_ : 0.0;
    const auto first = static_cast<Index>(place);
    return {first, place - static_cast<double>(first)};
  }

 private:
  double low_;
  double step_;
};

VectorXd stepsOf(const VectorXd& displacement) {
  const Index inner = displacement.size() - 2;
  VectorXd steps = VectorXd::Zero(displacement.size());
  steps.segment(1, inner) = displacement.tail(inner) - displacement.head(inner);
  return steps;
}

// Hat functions of the displacement while it rises, of the displacement while it falls, and of the speed.
class Columns {
 public:
  Columns(const VectorXd& displacement, Index count)
      : displacement_(displacement),
        speed_(stepsOf(displacement)),
        of_displacement_(displacement_, count),
        of_speed_(speed_, count),
        each_(count + 1) {}

  Index size() const { return 3 * each_; }

  // Returns the four functions that differ from 0 at a sample, with their values.
  std::array<std::pair<Index, double>, 4> at(Index sample) const {
    const auto [place, share] = of_displacement_.at(displacement_[sample]);
    const auto [pace, further] = of_speed_.at(speed_[sample]);
    const Index way = speed_[sample] < 0.0 ? each_ : 0;
    const Index speeds = 2 * each_;
    return {{{way + place, 1.0 - share},
             {way + place + 1, share},
             {speeds + pace, 1.0 - further},
             {speeds + pace + 1, further}}};
  }

 private:
  const VectorXd& displacement_;
  VectorXd speed_;
  Hats of_displacement_;
  Hats of_speed_;
  Index each_;
};

// Returns the number of hat functions of each kind that a log can determine: at most one per two cycles, and in total
// at most one per 50 samples, so that they absorb at most some percent of the noise.
Index tellable(const log::Record& record, const Mask& mask) {
  constexpr double kKinds = 3.0;
  constexpr double kMost = 12.0;
  const double cycles = record.mean_frequency * record.duration();
  return static_cast<Index>(std::min({kMost, 0.5 * cycles, static_cast<double>(mask.count()) / 50.0 / kKinds}));
}

VectorXd weightsOf(const Columns& columns, const VectorXd& residual, const Mask& mask) {
  MatrixXd gram = MatrixXd::Zero(columns.size(), columns.size());
  VectorXd moment = VectorXd::Zero(columns.size());
  for (Index i = 0; i < residual.size(); ++i) {
    if (!mask[i]) {
      continue;
    }
    const auto here = columns.at(i);
    for (const auto& [a, x] : here) {
      moment[a] += x * residual[i];
      for (const auto& [b, y] : here) {
        gram(a, b) += x * y;
      }
    }
  }
  return numerics::solveLeastNorm(gram, moment);  // singular: the functions of each kind add up to the same constant
}

}  // namespace

VectorXd withoutFunctionsOfMotion(const log::Record& record, const VectorXd& residual, const Mask& mask) {
  constexpr Index kFewest = 3;
  const Index count = tellable(record, mask);
  if (count < kFewest) {
    return residual;
  }
  const Columns columns(record.displacement, count);
  const VectorXd weights = weightsOf(columns, residual, mask);
  VectorXd rest = residual;
  for (Index i = 0; i < rest.size(); ++i) {
    for (const auto& [column, value] : columns.at(i)) {
      rest[i] -= value * weights[column];
    }
  }
  return rest;
}

}  // namespace rubber_suspension::measurement
