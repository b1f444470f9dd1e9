// Motions that represent the rows of a table, and their normal equations.
#include "fit/table_fitter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

#include "element/each.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/settled_loop.h"

namespace rubber_suspension::fit {
namespace {

constexpr int kSamplesOfLoop =
    360;  // samples of the cycle that counts; a dashpot lags by half a sample, 0.5 degrees of its force
constexpr int kStride = 4;   // samples of the cycle per sample of the lead-in
constexpr int kBefore = 3;   // samples of the record before the cycle that counts; they keep the lead-in's time grid
constexpr int kAfter = 1;    // samples after the cycle, because a mass uses differences on both sides
constexpr int kGrowing = 4;  // cycles of the lead-in in which the amplitude grows, so that element states end symmetric
constexpr int kSettling = 6;  // further cycles of the lead-in

// Returns the displacement at a sample. The cycle begins at its lower turning point with sample 0.
double displacementAt(const TablePoint& point, int sample) {
  const double phase = 2.0 * element::kPi * sample / kSamplesOfLoop;
  const double since_rest = static_cast<double>(sample) / kSamplesOfLoop + kGrowing + kSettling;
  const double grown = std::clamp(since_rest / kGrowing, 0.0, 1.0);
  return point.mean - point.amplitude * grown * std::cos(phase);
}

gap::PreparedRecord recordOf(const TablePoint& point) {
  gap::PreparedRecord record;
  record.dt = 1.0 / (point.frequency * kSamplesOfLoop);
  record.lead_in.dt = kStride * record.dt;
  constexpr int kLeadIn = (kGrowing + kSettling) * kSamplesOfLoop / kStride;
  record.lead_in.displacement.reserve(kLeadIn);
  for (int i = 0; i < kLeadIn; ++i) {
    record.lead_in.displacement.push_back(displacementAt(point, (i - kLeadIn) * kStride));
  }
  constexpr int kSize = kBefore + kSamplesOfLoop + kAfter;
  record.displacement.resize(kSize);
  record.force.resize(kSize);
  for (int i = 0; i < kSize; ++i) {
    const double phase = 2.0 * element::kPi * (i - kBefore) / kSamplesOfLoop;
    record.displacement[i] = displacementAt(point, i - kBefore);
    record.force[i] = -point.stiffness * point.amplitude * std::cos(phase + point.loss_angle);
  }
  record.raw_displacement = record.displacement;
  if (point.temperature) {
    record.temperature = Eigen::VectorXd::Constant(kSize, *point.temperature);
  }
  record.force_deviation = point.stiffness * point.amplitude / std::sqrt(2.0);
  record.lowest_frequency = record.mean_frequency = record.highest_frequency = point.frequency;
  return record;
}

// Returns the complex stiffness of the last cycle.
std::complex<double> stiffnessOfLoop(const TablePoint& point, const Eigen::VectorXd& force) {
  response::SettledLoop loop;
  loop.frequency = point.frequency;
  loop.amplitude = point.amplitude;
  loop.force.assign(force.data() + kBefore, force.data() + kBefore + kSamplesOfLoop);
  const response::Characteristics found = loop.characteristics();
  return std::polar(found.stiffness, found.loss_angle);
}

// Returns the imaginary part of K* from the area of the loop.
double lossStiffness(const TablePoint& point, const Eigen::VectorXd& force) {
  double sum = 0.0;
  for (int i = 0; i < kSamplesOfLoop; ++i) {
    sum += force[kBefore + i] * std::sin(2.0 * element::kPi * i / kSamplesOfLoop);
  }
  return 2.0 * sum / (kSamplesOfLoop * point.amplitude);
}

// Returns the rank of each row's value. Values that differ by less than 1e-6 have the same rank.
std::vector<int> ranksOf(const std::vector<TablePoint>& points, const std::function<double(const TablePoint&)>& value) {
  const auto below = [](double a, double b) { return b - a > 1e-6 * std::max(std::abs(a), std::abs(b)); };
  std::vector<double> values = element::each(points, value);
  const std::set<double, decltype(below)> levels(values.begin(), values.end(), below);
  return element::each(
      values, [&](double of_row) { return static_cast<int>(std::distance(levels.begin(), levels.find(of_row))); });
}

}  // namespace

TableLoops::TableLoops(std::vector<TablePoint> points) : points_(std::move(points)) {
  checkPoints(points_);
  records_ = std::make_shared<const std::vector<gap::PreparedRecord>>(element::each(points_, recordOf));
}

std::vector<std::complex<double>> TableLoops::stiffness(const gap::Forces& forces) const {
  std::vector<std::complex<double>> result;
  for (std::size_t r = 0; r < points_.size(); ++r) {
    result.push_back(stiffnessOfLoop(points_[r], forces[r]));
  }
  return result;
}

std::vector<std::complex<double>> TableLoops::stiffnessOf(
    const std::vector<element::ElementDescription>& elements) const {
  return stiffness(gap::simulate(elements, *records_));
}

// |K*| follows from the two peaks, whose times do not change to first order, and Im K* from the area.
std::complex<double> TableLoops::derivative(std::size_t row, const Eigen::VectorXd& force,
                                            const Eigen::VectorXd& column) const {
  const TablePoint& point = points_[row];
  Eigen::Index high = 0;
  Eigen::Index low = 0;
  force.segment(kBefore, kSamplesOfLoop).maxCoeff(&high);
  force.segment(kBefore, kSamplesOfLoop).minCoeff(&low);
  const std::complex<double> stiffness = stiffnessOfLoop(point, force);
  const double magnitude = (column[kBefore + high] - column[kBefore + low]) / (2.0 * point.amplitude);
  const double loss = lossStiffness(point, column);
  // Without storage stiffness, as for Coulomb friction alone, the derivative is infinite; 1 % avoids this.
  const double storage = std::max(std::abs(stiffness.real()), 0.01 * std::abs(stiffness));
  return {(std::abs(stiffness) * magnitude - stiffness.imag() * loss) / storage, loss};
}

TableFitter::TableFitter(std::shared_ptr<const TableLoops> loops, const ModelParameters& model, double one_deviation)
    : HypothesisFitter(model, one_deviation), loops_(std::move(loops)), forces_(loops_->records(), model) {
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

double TableFitter::gapOf(const Hypothesis& /*hypothesis*/, const gap::Forces& forces) const {
  const double gap = gapOfTable(loops_->points(), loops_->stiffness(forces));
  return std::isfinite(gap) ? gap : std::numeric_limits<double>::infinity();
}

// Rows have no nuisance parameters, so one result applies to all entries of `how.free`.
std::vector<BlockGrams> TableFitter::normalEquationsAbout(const Hypothesis& hypothesis,
                                                          const ParameterVector& parameters, const gap::Forces& base,
                                                          const Linearised& how) const {
  const std::vector<ForceColumn> columns = forces_.columns(hypothesis, parameters, how.active, base, how.threads);
  const std::vector<std::complex<double>> model = loops_->stiffness(base);
  const auto unknowns = static_cast<Eigen::Index>(columns.size());
  const double share = 1.0 / static_cast<double>(base.size());
  BlockGrams result;
  result.fold = fold_;
  result.record.assign(base.size(), 0);
  result.weight.assign(base.size(), share);
  result.prior = Eigen::MatrixXd::Zero(unknowns + 1, unknowns + 1);
  result.squares = Eigen::VectorXd::Zero(unknowns + 1);
  for (std::size_t r = 0; r < base.size(); ++r) {
    const std::complex<double> measured = loops_->points()[r].complexStiffness();
    Eigen::VectorXcd row = Eigen::VectorXcd::Zero(unknowns + 1);
    for (Eigen::Index j = 0; j < unknowns; ++j) {
      if (const ForceColumn& column = columns[static_cast<std::size_t>(j)]) {
        row[j] = loops_->derivative(r, base[r], (*column)[r]);
      }
    }
    row[unknowns] = measured - model[r];
    row *= std::sqrt(share) / std::abs(measured);
    result.gram.emplace_back((row.conjugate() * row.transpose()).real());
    result.squares += result.gram.back().diagonal();
  }
  result.sumUp();
  return std::vector<BlockGrams>(how.free.size(), result);
}

}  // namespace rubber_suspension::fit
