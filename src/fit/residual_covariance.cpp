// Autoregressive residuals: Levinson-Durbin recursion and filtering of the Jacobian.
#include "fit/residual_covariance.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::fit {
namespace {

constexpr Eigen::Index kLargestOrder = 30;

constexpr Eigen::Index kFilterBlock = 256;  // rows that stay in the first-level cache

// y_t = x_t - sum a_i y_(t+i), one block of rows after the other from the last one on; all columns side by side.
class BackwardFilter {
 public:
  BackwardFilter(const Autoregression& model, Eigen::Index columns)
      : model_(model), rows_(RowMajor::Zero(kFilterBlock + order(), columns)) {}

  // Filters the rows before those of the last call, and adds the products of their columns.
  void addProducts(const Eigen::Ref<const Eigen::MatrixXd>& rows, Eigen::MatrixXd& sum) {
    // Those of the last call that the recursion still needs follow the new ones.
    const RowMajor later = rows_.topRows(order());
    rows_.topRows(rows.rows()) = rows;
    rows_.middleRows(rows.rows(), order()) = later;
    const Eigen::Index columns = rows_.cols();
    for (Eigen::Index t = rows.rows() - 1; t >= 0; --t) {
      double* const row = rows_.data() + t * columns;
      for (std::size_t i = 0; i < model_.coefficients.size(); ++i) {
        const double coefficient = model_.coefficients[i];
        const double* const later_row = row + (static_cast<Eigen::Index>(i) + 1) * columns;
        for (Eigen::Index k = 0; k < columns; ++k) {
          row[k] -= coefficient * later_row[k];
        }
      }
    }
    const auto filtered = rows_.topRows(rows.rows());
    sum += filtered.transpose() * filtered;
  }

 private:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::Index order() const { return static_cast<Eigen::Index>(model_.coefficients.size()); }

  const Autoregression& model_;
  RowMajor rows_;
};

// Autocovariances at lags 0 to `lags`, products within runs only.
std::vector<double> autocovariances(const Eigen::VectorXd& residuals, const std::vector<Eigen::Index>& runs,
                                    Eigen::Index lags) {
  std::vector<double> sums(static_cast<std::size_t>(lags) + 1, 0.0);
  Eigen::Index begin = 0;
  for (const Eigen::Index length : runs) {
    for (Eigen::Index lag = 0; lag <= std::min(lags, length - 1); ++lag) {
      sums[static_cast<std::size_t>(lag)] +=
          residuals.segment(begin, length - lag).dot(residuals.segment(begin + lag, length - lag));
    }
    begin += length;
  }
  for (double& sum : sums) {
    sum /= static_cast<double>(residuals.size());
  }
  return sums;
}

// One more coefficient of the Levinson-Durbin recursion.
void raiseOrder(Autoregression& model, const std::vector<double>& covariance) {
  const std::size_t order = model.coefficients.size();
  double correlation = covariance[order + 1];
  for (std::size_t i = 0; i < order; ++i) {
    correlation += model.coefficients[i] * covariance[order - i];
  }
  const double reflection = -correlation / model.innovation;
  const std::vector<double> before = model.coefficients;
  for (std::size_t i = 0; i < order; ++i) {
    model.coefficients[i] += reflection * before[order - 1 - i];
  }
  model.coefficients.push_back(reflection);
  model.innovation *= 1.0 - reflection * reflection;
}

}  // namespace

Autoregression fitAutoregression(const Eigen::VectorXd& residuals, const std::vector<Eigen::Index>& runs) {
  const Eigen::Index longest = *std::max_element(runs.begin(), runs.end());
  const Eigen::Index largest_order = std::min(kLargestOrder, longest / 20);
  const std::vector<double> covariance = autocovariances(residuals, runs, largest_order);
  Autoregression model;
  model.innovation = covariance[0];
  Autoregression best = model;
  const auto count = static_cast<double>(residuals.size());
  // Residuals at the rounding of the forces have no structure worth a model.
  const double floor = 1e-14 * covariance[0];
  double best_criterion = count * std::log(std::max(model.innovation, 1e-300));
  for (Eigen::Index order = 1; order <= largest_order && model.innovation > floor; ++order) {
    raiseOrder(model, covariance);
    const double criterion =
        count * std::log(std::max(model.innovation, 1e-300)) + static_cast<double>(order) * std::log(count);
    if (criterion < best_criterion) {
      best_criterion = criterion;
      best = model;
    }
  }
  return best;
}

Eigen::MatrixXd projectedCovariance(const Eigen::MatrixXd& jacobian, const std::vector<Eigen::Index>& runs,
                                    const Autoregression& model) {
  // O = s^2 A^-1 A^-T, A being the filter of the autoregression as a triangular matrix; A^-T runs backwards in time.
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  Eigen::Index begin = 0;
  for (const Eigen::Index length : runs) {
    BackwardFilter filter(model, jacobian.cols());
    for (Eigen::Index end = begin + length; end > begin; end -= kFilterBlock) {
      const Eigen::Index rows = std::min(kFilterBlock, end - begin);
      filter.addProducts(jacobian.middleRows(end - rows, rows), sum);
    }
    begin += length;
  }
  return model.innovation * sum;
}

double correlationFactor(const Autoregression& model, double variance) {
  double sum = 1.0;
  for (const double coefficient : model.coefficients) {
    sum += coefficient;
  }
  return variance > 0.0 ? model.innovation / (sum * sum) / variance : 1.0;
}

}  // namespace rubber_suspension::fit
