// Predicts the residual of one direction by the displacement of another, with cross-validated least squares.
#include "diagnosis/results/cross_map.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/least_squares.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr std::size_t kFolds = 5;
constexpr std::size_t kBlocks = 100;         // number of blocks per log; each fold is every fifth block
constexpr std::size_t kMostMapped = 100000;  // approximate upper limit of the number of samples
constexpr double kLeastOfLargest = 0.02;     // least motion relative to the largest translation or rotation
constexpr double kLeastOfItsOwn = 0.01;      // least share of the variance that the other direction does not predict
constexpr Eigen::Index kOwn = 6;             // number of basis functions of one direction alone
constexpr Eigen::Index kAll = 13;            // number of basis functions of both directions
constexpr Eigen::Index kResidual = kAll;     // column of the residual, behind the basis functions
using Moments = Eigen::Matrix<double, kAll + 1, kAll + 1>;

double mean(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).mean();
}

// Returns the standard deviation of the displacement over all logs, each relative to its own mean.
double motionOf(const std::vector<DirectionResiduals>& logs, std::size_t direction) {
  double square = 0.0;
  double count = 0.0;
  for (const DirectionResiduals& log : logs) {
    const std::vector<double>& values = log[direction].displacement;
    const double centre = mean(values);
    for (const double value : values) {
      square += (value - centre) * (value - centre);
    }
    count += static_cast<double>(values.size());
  }
  return std::sqrt(square / count);
}

bool moves(const std::vector<DirectionResiduals>& logs, component::Direction by) {
  const std::size_t first = component::isRotation(by) ? component::kRx : component::kX;
  double largest = 0.0;
  for (std::size_t k = first; k < first + 3; ++k) {
    largest = std::max(largest, motionOf(logs, k));
  }
  return largest > 0.0 && motionOf(logs, by) >= kLeastOfLargest * largest;
}

// Maps the values of all logs linearly to the interval from -1 to 1.
class Scale {
 public:
  void take(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    least_ = std::min(least_, *least);
    most_ = std::max(most_, *most);
  }

  double operator()(double value) const {
    return most_ > least_ ? (2.0 * value - most_ - least_) / (most_ - least_) : 0.0;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

// Returns the rates [m/s] at inner samples, and 0 at the first and the last sample.
std::vector<double> ratesOf(const log::Log& log) {
  std::vector<double> rates(log.size(), 0.0);
  for (std::size_t i = 1; i + 1 < log.size(); ++i) {
    rates[i] = (log.displacement[i + 1] - log.displacement[i - 1]) / (log.time(i + 1) - log.time(i - 1));
  }
  return rates;
}

struct Scales {
  Scale own;
  Scale rate;
  Scale other;
};

// Evaluates the basis functions on a log, adds their products to the fold of each sample, and returns the number of
// rows. The means of the log are removed, because an offset of the rig is no coupling.
Eigen::Index addMoments(const log::Log& own, const log::Log& other, const Scales& scales, std::size_t stride,
                        std::array<Moments, kFolds>& moments) {
  const std::vector<double> rates = ratesOf(own);
  const auto rows = static_cast<Eigen::Index>((own.size() + stride - 1) / stride);
  Eigen::MatrixXd columns(rows, kAll + 1);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const std::size_t i = static_cast<std::size_t>(row) * stride;
    const double a = scales.own(own.displacement[i]);
    const double b = scales.other(other.displacement[i]);
    const double c = scales.rate(rates[i]);
    columns.row(row) << a, a * a, a * a * a, c, c * c, c * c * c, b, b * b, b * b * b, a * b, a * a * b, a * b * b,
        c * b, own.force[i];
  }
  columns.rowwise() -= columns.colwise().mean().eval();
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const Eigen::Index begin = rows * static_cast<Eigen::Index>(block) / static_cast<Eigen::Index>(kBlocks);
    const Eigen::Index end = rows * static_cast<Eigen::Index>(block + 1) / static_cast<Eigen::Index>(kBlocks);
    const auto part = columns.middleRows(begin, end - begin);
    moments[block % kFolds] += part.transpose() * part;
  }
  return rows;
}

// Returns the squared error of predicting the residual of a fold by the first `count` basis functions, whose
// coefficients are fitted to the other folds.
double errorOn(const Moments& fold, const Moments& all, Eigen::Index count) {
  const Moments others = all - fold;
  const Eigen::VectorXd x = numerics::solveLeastNorm(Eigen::MatrixXd(others.topLeftCorner(count, count)),
                                                     Eigen::VectorXd(others.col(kResidual).head(count)));
  return fold(kResidual, kResidual) - 2.0 * x.dot(fold.col(kResidual).head(count)) +
         x.dot(fold.topLeftCorner(count, count) * x);
}

// Returns the share of the variance of the other displacement that the motion of the direction does not explain.
double apartFrom(const Moments& all) {
  const Eigen::VectorXd column = all.col(kOwn).head(kOwn);
  const Eigen::VectorXd x =
      numerics::solveLeastNorm(Eigen::MatrixXd(all.topLeftCorner<kOwn, kOwn>()), Eigen::VectorXd(column));
  return all(kOwn, kOwn) > 0.0 ? 1.0 - x.dot(column) / all(kOwn, kOwn) : 0.0;
}

}  // namespace

CrossShare crossShare(const std::vector<DirectionResiduals>& logs, component::Direction of, component::Direction by) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::size_t samples = 0;
  Scales scales;
  for (const DirectionResiduals& log : logs) {
    samples += log[of].size();
    scales.own.take(log[of].displacement);
    scales.rate.take(ratesOf(log[of]));
    scales.other.take(log[by].displacement);
  }
  const std::size_t stride = samples / kMostMapped + 1;
  std::array<Moments, kFolds> moments;
  moments.fill(Moments::Zero());
  double rows = 0.0;
  for (const DirectionResiduals& log : logs) {
    rows += static_cast<double>(addMoments(log[of], log[by], scales, stride, moments));
  }
  Moments all = Moments::Zero();
  for (const Moments& fold : moments) {
    all += fold;
  }
  if (!moves(logs, by) || apartFrom(all) < kLeastOfItsOwn) {
    return {of, by, kNone, kNone};
  }
  double alone = 0.0;
  double together = 0.0;
  for (const Moments& fold : moments) {
    alone += errorOn(fold, all, kOwn);
    together += errorOn(fold, all, kAll);
  }
  const double gained = std::max(0.0, alone - together);
  const double squares = all(kResidual, kResidual);
  return {of, by, squares > 0.0 ? std::min(1.0, gained / squares) : 0.0, std::sqrt(gained / rows)};
}

}  // namespace rubber_suspension::diagnosis::results
