// Computes loops in windows of logs, and the loop of the whole component at its nominal point.
#include "diagnosis/results/characteristics.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "element/each.h"
#include "numerics/fourier.h"
#include "numerics/median.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::diagnosis::results {
namespace {

// Number of mean cycles in a window. With twelve cycles, an incomplete cycle matters little, and in most tests
// amplitude and frequency hardly change within a window.
constexpr double kCyclesOfWindow = 12.0;

struct Loop {
  std::complex<double> stiffness;
  double energy = 0.0;
  double energy_scale = 0.0;  // integral of |F - mean F| over |dz|, which scales energies
};

std::vector<std::complex<double>> spectrumAboutMean(const Eigen::VectorXd& values) {
  const Eigen::VectorXd about_mean = values.array() - values.mean();
  return numerics::paddedSpectrum({about_mean.begin(), about_mean.end()});
}

Loop loopOf(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force) {
  const std::vector<std::complex<double>> z = spectrumAboutMean(displacement);
  const std::vector<std::complex<double>> f = spectrumAboutMean(force);
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

double amplitudeOf(const log::Record& record) {
  const Eigen::ArrayXd z = record.displacement.array() - record.displacement.mean();
  return std::sqrt(2.0 * z.square().mean());
}

double medianAmplitude(const std::vector<gap::PreparedRecord>& logs, double frequency) {
  std::vector<double> near;
  std::vector<double> all;
  for (const log::Record& record : logs) {
    all.push_back(amplitudeOf(record));
    if (std::abs(std::log2(record.mean_frequency / frequency)) <= 1.0) {
      near.push_back(all.back());
    }
  }
  return numerics::medianOf(near.empty() ? all : near);
}

// Returns the characteristics after at most 20 cycles, as a testing machine measures them. Later cycles would include
// the
// heating and drift that continue for minutes.
std::optional<response::Characteristics> measuredAt(const io::ComponentDescription& component, double frequency,
                                                    double amplitude) {
  response::LoopOptions options;
  options.maximum_cycles = 20;
  try {
    const auto point =
        response::characteristicsAt(component.withoutRig().makeComponent(), frequency, amplitude, options);
    return std::isfinite(point.characteristics.stiffness) ? std::optional(point.characteristics) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

CharacteristicErrors characteristicErrors(const std::vector<gap::PreparedRecord>& records,
                                          const std::vector<Eigen::VectorXd>& simulated) {
  CharacteristicErrors sum{0.0, 0.0, 0.0};
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
        continue;  // the displacement is at rest in this window, so that there is no loop
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

std::optional<WholeStiffness> wholeStiffness(const io::ComponentDescription& before,
                                             const io::ComponentDescription& after,
                                             const std::vector<gap::PreparedRecord>& logs) {
  const std::vector<double> frequencies = element::each(logs, &log::Record::mean_frequency);
  const auto& specification = before.specification();
  WholeStiffness whole;
  whole.frequency =
      specification.has("nominal_frequency") ? specification.at("nominal_frequency") : numerics::medianOf(frequencies);
  whole.nominal_amplitude = specification.has("nominal_amplitude");
  whole.amplitude =
      whole.nominal_amplitude ? specification.at("nominal_amplitude") : medianAmplitude(logs, whole.frequency);
  const auto was = measuredAt(before, whole.frequency, whole.amplitude);
  const auto is = measuredAt(after, whole.frequency, whole.amplitude);
  if (!was || !is) {
    return std::nullopt;
  }
  whole.stiffness = {was->stiffness, is->stiffness};
  whole.loss_angle = {was->loss_angle, is->loss_angle};
  return whole;
}

}  // namespace rubber_suspension::diagnosis::results
