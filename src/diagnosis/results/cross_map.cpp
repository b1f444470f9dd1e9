// Cross-validated least squares on parts of the logs.
#include "diagnosis/results/cross_map.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/least_squares.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr std::size_t kFolds = 5;
constexpr std::size_t kBlocks = 100;         // of each log; every fifth is left out in turn
constexpr std::size_t kMostMapped = 100000;  // samples of all logs
constexpr double kLeastOfLargest = 0.02;     // of the motion of the largest translation or rotation
constexpr double kLeastOfItsOwn = 0.01;      // share of its variance that does not follow the other direction
constexpr Eigen::Index kOwn = 6;             // columns of the direction alone
constexpr Eigen::Index kAll = 13;            // columns of both directions
constexpr Eigen::Index kResidual = kAll;     // column of the residual, behind these
using Moments = Eigen::Matrix<double, kAll + 1, kAll + 1>;

double mean(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).mean();
}

// Standard deviation of the displacement over all logs, about the mean of each.
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

// Scales the values of all logs to -1 ... 1.
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

// Rates [m/s] at inner samples, 0 at the ends.
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

// Adds the products of the columns of a log to those of the fold that each sample belongs to, and returns the number of
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

// Squared error in a fold when its first `count` columns predict it with coefficients that are fitted to the others.
double errorOn(const Moments& fold, const Moments& all, Eigen::Index count) {
  const Moments others = all - fold;
  const Eigen::VectorXd x = numerics::solveLeastNorm(Eigen::MatrixXd(others.topLeftCorner(count, count)),
                                                     Eigen::VectorXd(others.col(kResidual).head(count)));
  return fold(kResidual, kResidual) - 2.0 * x.dot(fold.col(kResidual).head(count)) +
         x.dot(fold.topLeftCorner(count, count) * x);
}

// Share of the variance of the other displacement that the motion of the direction does not explain.
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
