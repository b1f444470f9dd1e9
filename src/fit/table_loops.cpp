// Motions of the rows of a table.
#include "fit/table_loops.h"

#include <algorithm>
#include <cmath>

#include "gap/simulate.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/settled_loop.h"

namespace rubber_suspension::fit {
namespace {

constexpr int kSamplesOfLoop =
    360;                      // of the cycle that counts: a dashpot lags by half a sample, 0.5 degrees of its force
constexpr int kStride = 4;    // of these, to one of the lead-in
constexpr int kBefore = 3;    // samples of the record before the cycle that counts, so that the lead-in keeps its grid
constexpr int kAfter = 1;     // and after it: a mass takes differences on both sides
constexpr int kGrowing = 4;   // cycles of the lead-in in which the sine grows: what is slow or rubs is left symmetric
constexpr int kSettling = 6;  // cycles of the lead-in after that

// Displacement at a sample, counted from the lower turning point at which the cycle begins.
double displacementAt(const TablePoint& point, int sample) {
  const double phase = 2.0 * element::kPi * sample / kSamplesOfLoop;
  const double since_rest = static_cast<double>(sample) / kSamplesOfLoop + kGrowing + kSettling;
  const double grown = std::clamp(since_rest / kGrowing, 0.0, 1.0);
  return point.mean - point.amplitude * grown * std::cos(phase);
}

log::Record recordOf(const TablePoint& point) {
  log::Record record;
  record.dt = 1.0 / (point.frequency * kSamplesOfLoop);
  record.lead_in_dt = kStride * record.dt;
  constexpr int kLeadIn = (kGrowing + kSettling) * kSamplesOfLoop / kStride;
  record.lead_in.resize(kLeadIn);
  for (int i = 0; i < kLeadIn; ++i) {
    record.lead_in[i] = displacementAt(point, (i - kLeadIn) * kStride);
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

// The cycle that counts.
response::SettledLoop loopOf(const TablePoint& point, const Eigen::VectorXd& force) {
  response::SettledLoop loop;
  loop.frequency = point.frequency;
  loop.amplitude = point.amplitude;
  loop.force.assign(force.data() + kBefore, force.data() + kBefore + kSamplesOfLoop);
  return loop;
}

std::complex<double> stiffnessOfLoop(const TablePoint& point, const Eigen::VectorXd& force) {
  const response::Characteristics loop = loopOf(point, force).characteristics();
  return std::polar(loop.stiffness, loop.loss_angle);
}

// Imaginary part of K*, by the area of the loop.
double lossStiffness(const TablePoint& point, const Eigen::VectorXd& force) {
  double sum = 0.0;
  for (int i = 0; i < kSamplesOfLoop; ++i) {
    sum += force[kBefore + i] * std::sin(2.0 * element::kPi * i / kSamplesOfLoop);
  }
  return 2.0 * sum / (kSamplesOfLoop * point.amplitude);
}

}  // namespace

TableLoops::TableLoops(std::vector<TablePoint> points) : points_(std::move(points)) {
  checkPoints(points_);
  auto records = std::make_shared<std::vector<log::Record>>();
  std::transform(points_.begin(), points_.end(), std::back_inserter(*records), recordOf);
  records_ = std::move(records);
}

std::vector<std::complex<double>> TableLoops::stiffness(const std::vector<Eigen::VectorXd>& forces) const {
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

// |K*| follows from the two peaks, which to first order stay where they are, and Im K* from the area.
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
  // Where all force is lost, as by Coulomb friction alone, the root has no slope: a percent keeps the step finite.
  const double storage = std::max(std::abs(stiffness.real()), 0.01 * std::abs(stiffness));
  return {(std::abs(stiffness) * magnitude - stiffness.imag() * loss) / storage, loss};
}

}  // namespace rubber_suspension::fit
