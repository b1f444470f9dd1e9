// Errors of stiffness, loss angle and energy per cycle.
#include "diagnosis/results/characteristics.h"

#include <cmath>
#include <complex>

#include "numerics/fourier.h"

namespace rubber_suspension::diagnosis::results {
namespace {

// Of the mean frequency in a window: a window does not end where a cycle does, which a dozen make little of, and
// amplitude and frequency do not change much meanwhile in most tests.
constexpr double kCyclesOfWindow = 12.0;

struct Loop {
  std::complex<double> stiffness;
  double energy = 0.0;
  double energy_scale = 0.0;  // pi/4 (Fmax - Fmin)(zmax - zmin) per radian of the window's motion
};

// About the mean and filled with zeros to a power of two: fast at any length.
std::vector<double> padded(const Eigen::VectorXd& values) {
  std::size_t length = 2;
  while (length < static_cast<std::size_t>(values.size())) {
    length *= 2;
  }
  std::vector<double> result(length, 0.0);
  Eigen::Map<Eigen::VectorXd>(result.data(), values.size()) = values.array() - values.mean();
  return result;
}

Loop loopOf(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force) {
  numerics::Fourier fourier;
  const std::vector<std::complex<double>> z = fourier.halfSpectrum(padded(displacement));
  const std::vector<std::complex<double>> f = fourier.halfSpectrum(padded(force));
  std::complex<double> cross = 0.0;
  double power = 0.0;
  for (std::size_t i = 1; i < z.size() - 1; ++i) {
    cross += f[i] * std::conj(z[i]);
    power += std::norm(z[i]);
  }
  Loop loop;
  loop.stiffness = power > 0.0 ? cross / power : std::complex<double>(0.0);
  const Eigen::Index steps = displacement.size() - 1;
  const Eigen::VectorXd travel = displacement.tail(steps) - displacement.head(steps);
  loop.energy = 0.5 * travel.dot(force.tail(steps) + force.head(steps));
  loop.energy_scale = travel.cwiseAbs().dot((force.tail(steps).array() - force.mean()).abs().matrix());
  return loop;
}

}  // namespace

CharacteristicErrors characteristicErrors(const std::vector<log::Record>& records,
                                          const std::vector<Eigen::VectorXd>& simulated) {
  CharacteristicErrors sum;
  double windows = 0.0;
  double energy_reference = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const log::Record& record = records[r];
    const auto count = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(record.duration() * record.mean_frequency / kCyclesOfWindow));
    for (Eigen::Index w = 0; w < count; ++w) {
      const Eigen::Index first = record.size() * w / count;
      const Eigen::Index length = record.size() * (w + 1) / count - first;
      const Eigen::VectorXd z = record.displacement.segment(first, length);
      const double range = z.maxCoeff() - z.minCoeff();
      if (range < 1e-3 * (record.displacement.maxCoeff() - record.displacement.minCoeff())) {
        continue;  // a hold: no loop
      }
      const Loop measured = loopOf(z, record.force.segment(first, length));
      const Loop model = loopOf(z, simulated[r].segment(first, length));
      sum.stiffness += std::pow(std::abs(model.stiffness) / std::abs(measured.stiffness) - 1.0, 2);
      sum.loss_angle += std::pow(std::arg(model.stiffness) - std::arg(measured.stiffness), 2);
      const double scale = 1.0 / std::max(1e-300, measured.energy_scale * measured.energy_scale);
      sum.energy += scale * std::pow(model.energy - measured.energy, 2);
      energy_reference += scale * measured.energy * measured.energy;
      windows += 1.0;
    }
  }
  if (windows > 0.0) {
    sum.stiffness = std::sqrt(sum.stiffness / windows);
    sum.loss_angle = std::sqrt(sum.loss_angle / windows);
    sum.energy = std::sqrt(sum.energy / std::max(1e-300, energy_reference));
  }
  return sum;
}

}  // namespace rubber_suspension::diagnosis::results
