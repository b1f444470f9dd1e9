// Normal equations of the rows of a table.
#include "fit/table_fitter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rubber_suspension::fit {
namespace {

// Place of each row's value among all that differ by more than a part in a million.
std::vector<int> ranksOf(const std::vector<TablePoint>& points, const std::function<double(const TablePoint&)>& value) {
  std::vector<double> levels;
  for (const TablePoint& point : points) {
    levels.push_back(value(point));
  }
  std::sort(levels.begin(), levels.end());
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)); };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  std::vector<int> ranks;
  for (const TablePoint& point : points) {
    const auto found = std::find_if(levels.begin(), levels.end(), [&](double l) { return same(l, value(point)); });
    ranks.push_back(static_cast<int>(found - levels.begin()));
  }
  return ranks;
}

}  // namespace

TableFitter::TableFitter(std::shared_ptr<const TableLoops> loops, const ModelParameters& model, double noise)
    : HypothesisFitter(model), loops_(std::move(loops)), forces_(loops_->records(), model) {
  setNoise(noise);
  const std::vector<TablePoint>& points = loops_->points();
  const std::vector<int> by_frequency = ranksOf(points, [](const TablePoint& point) { return point.frequency; });
  const std::vector<int> by_amplitude = ranksOf(points, [](const TablePoint& point) { return point.amplitude; });
  const std::vector<int> by_mean = ranksOf(points, [](const TablePoint& point) { return point.mean; });
  const std::vector<int> by_temperature =
      ranksOf(points, [](const TablePoint& point) { return point.temperature.value_or(0.0); });
  for (std::size_t r = 0; r < points.size(); ++r) {
    fold_.push_back((by_frequency[r] + by_amplitude[r] + by_mean[r] + by_temperature[r]) % kFolds);
  }
}

std::optional<std::vector<std::complex<double>>> TableFitter::stiffness(const Hypothesis& hypothesis,
                                                                        const ParameterVector& parameters) const {
  const auto forces = forces_.at(hypothesis, parameters);
  return forces ? std::optional(loops_->stiffness(*forces)) : std::nullopt;
}

double TableFitter::gapOf(const Hypothesis& /*hypothesis*/, const Forces& forces) const {
  const double gap = gapOfTable(loops_->points(), loops_->stiffness(forces));
  return std::isfinite(gap) ? gap : std::numeric_limits<double>::infinity();
}

BlockGrams TableFitter::normalEquationsAbout(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                             const Forces& base, FreeInLog /*free*/, const std::vector<bool>& active,
                                             int threads) const {
  const std::vector<ForceColumn> columns = forces_.columns(hypothesis, parameters, active, base, threads);
  const std::vector<std::complex<double>> model = loops_->stiffness(base);
  const auto unknowns = static_cast<Eigen::Index>(columns.size());
  const double rows = static_cast<double>(base.size());
  BlockGrams result;
  result.fold = fold_;
  result.record.assign(base.size(), 0);
  result.weight.assign(base.size(), 1.0 / rows);
  for (std::size_t r = 0; r < base.size(); ++r) {
    const std::complex<double> measured = loops_->points()[r].complexStiffness();
    const double weight = 1.0 / (std::abs(measured) * std::sqrt(rows));
    Eigen::MatrixXd local = Eigen::MatrixXd::Zero(2, unknowns + 1);
    const auto set = [&](Eigen::Index column, std::complex<double> value) {
      local(0, column) = weight * value.real();
      local(1, column) = weight * value.imag();
    };
    for (Eigen::Index j = 0; j < unknowns; ++j) {
      const ForceColumn& column = columns[static_cast<std::size_t>(j)];
      if (column) {
        set(j, loops_->derivative(r, base[r], (*column)[r]));
      }
    }
    set(unknowns, measured - model[r]);
    result.gram.emplace_back(local.transpose() * local);
    result.squares = (result.squares.size() == 0 ? Eigen::VectorXd::Zero(unknowns + 1) : result.squares) +
                     result.gram.back().diagonal();
  }
  return result;
}

}  // namespace rubber_suspension::fit
