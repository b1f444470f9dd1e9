// Virtual rigs with known forces, and errors that benches add to logs: offsets, starts in motion, spikes, noise.
#pragma once

#include <unsupported/Eigen/FFT>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/record.h"
#include "support/kit.h"

namespace rubber_suspension::measurement {

using Elements = std::vector<element::ElementDescription>;

enum class Law { maxwell, friction, progressive };
enum class Motion { sines, sweep, track, holds };

/// A bench with a component. Its lengths, forces and times can be multiplied by scale factors.
struct VirtualRig {
  Law law = Law::maxwell;
  Motion motion = Motion::track;
  unsigned seed = 1;
  double noise = 0.003;     // noise of the force, relative to the standard deviation of the force
  double sampling = 500.0;  // [Hz]
  double duration = 20.0;   // [s]
  double length = 1.0;      // scale factors
  double force = 1.0;
  double time = 1.0;
};

/// Errors of the bench. Shares are relative to the range of the channel.
struct Perturbation {
  double force_zero = 0.0;
  double displacement_zero = 0.0;
  bool running_start = false;
  double spikes = 0.0;      // size of three spikes in each channel
  int held = 0;             // samples in each of three holds of the force
  double clipped = 0.0;     // share of the range that is cut off at the top of the force
  bool pink = false;        // the noise is 1/f
  double anti_alias = 0.0;  // corner frequency of a fourth-order low-pass of the noise, in cycles per sample
  double gain = 0.0;
  double delay = 0.0;  // samples
  double clock = 0.0;  // relative error
  bool sign = false;
  double factor = 1.0;
  bool swapped = false;
};

/// A log, and the errors that were added to this log.
struct VirtualLog {
  log::Log log;
  double force_zero = 0.0;         // [N]
  double displacement_zero = 0.0;  // [m]
  double transient = 0.0;          // force at the start due to the motion before the log [N]
  double delay = 0.0;              // delay in the middle of the log [s]
  double noise = 0.0;              // standard deviation of the added noise [N]
  std::vector<Eigen::Index> spikes;
};

inline Elements elementsOf(const VirtualRig& rig) {
  const double stiffness = 1e6 * rig.force / rig.length;
  Elements elements = {spring(stiffness), maxwell(0.5 * stiffness, 3.0 / rig.time)};
  if (rig.law == Law::friction) {
    elements.push_back(friction(400.0 * rig.force, 4e-4 * rig.length));
  }
  if (rig.law == Law::progressive) {
    elements.push_back({"progressive_stiffness", {{"cubic", {1e11 * rig.force / std::pow(rig.length, 3)}}}});
  }
  return elements;
}

/// Displacement in units of 2 mm as a function of time [s], at rest before time 0.
class Programme {
 public:
  Programme(Motion motion, unsigned seed, double duration) : motion_(motion), duration_(duration) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 40; ++i) {
      const double frequency = 0.3 * std::pow(15.0 / 0.3, (i + uniform(generator)) / 40.0);
      frequency_.push_back(frequency);
      amplitude_.push_back(0.35 * std::pow(frequency, -0.7));
      phase_.push_back(2.0 * element::kPi * uniform(generator));
    }
  }

  double operator()(double time) const {
    const double edge = std::min({1.0, std::max(time, 0.0) / 0.8, std::max(duration_ - time, 0.0) / 0.8});
    const double envelope = 0.5 - 0.5 * std::cos(element::kPi * edge);
    return envelope * inner(std::max(time, 0.0));
  }

 private:
  double inner(double time) const {
    switch (motion_) {
      case Motion::sines:
        return sines(time);
      case Motion::sweep: {
        const double growth = std::log(15.0 / 0.3) / duration_;
        const double frequency = 0.3 * std::exp(growth * time);
        return std::min(1.0, 3.0 / frequency) * std::sin(2.0 * element::kPi * 0.3 * std::expm1(growth * time) / growth);
      }
      case Motion::track: {
        double sum = 0.0;
        for (std::size_t i = 0; i < phase_.size(); ++i) {
          sum += amplitude_[i] * std::sin(2.0 * element::kPi * frequency_[i] * time + phase_[i]);
        }
        return sum;
      }
      default:
        return holds(time);
    }
  }

  // Returns the displacement of four blocks with one frequency and amplitude each, joined smoothly.
  double sines(double time) const {
    const double block = duration_ / 4.0;
    const auto i = static_cast<std::size_t>(std::min(3.0, std::floor(time / block)));
    const double local = time - static_cast<double>(i) * block;
    const double edge = std::min({1.0, local / 0.4, (block - local) / 0.4});
    const double envelope = 0.5 - 0.5 * std::cos(element::kPi * std::max(edge, 0.0));
    const double amplitude[] = {1.0, 0.4, 0.8, 0.2};
    return amplitude[i] * envelope * std::sin(2.0 * element::kPi * std::min(frequency_[10 * i + 5], 6.0) * local);
  }

  // Returns the displacement of ramps to levels that are then held.
  double holds(double time) const {
    const double step = duration_ / 8.0;
    const auto i = static_cast<std::size_t>(std::min(7.0, std::floor(time / step)));
    const double level[] = {0.0, 0.5, 1.0, 0.3, -0.6, -1.0, 0.2, 0.8, 0.0};
    const double share = std::clamp((time - static_cast<double>(i) * step) / 0.3, 0.0, 1.0);
    return level[i] + (level[i + 1] - level[i]) * (0.5 - 0.5 * std::cos(element::kPi * share));
  }

  Motion motion_;
  double duration_;
  std::vector<double> frequency_;
  std::vector<double> amplitude_;
  std::vector<double> phase_;
};

inline std::vector<Eigen::VectorXd> simulateAll(const Elements& elements, const std::vector<double>& steps,
                                                const std::vector<Eigen::VectorXd>& displacements) {
  const component::Component component(elements);
  std::vector<Eigen::VectorXd> forces;
  for (std::size_t i = 0; i < displacements.size(); ++i) {
    component::ComponentState state = component.makeState();
    Eigen::VectorXd force(displacements[i].size());
    force[0] = component.initialise(state, displacements[i][0]).total;
    component.simulate(state, steps[i], displacements[i].data() + 1, static_cast<std::size_t>(force.size() - 1),
                       force.data() + 1);
    forces.push_back(force);
  }
  return forces;
}

/// Returns white, 1/f or low-pass filtered noise with a standard deviation of 1.
inline Eigen::VectorXd unitNoise(Eigen::Index count, const Perturbation& p, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Eigen::Index size = 1;
  while (size < 2 * count) {
    size *= 2;
  }
  std::vector<double> white(static_cast<std::size_t>(p.pink ? size : count + 200));
  std::generate(white.begin(), white.end(), [&] { return normal(generator); });
  if (p.pink) {
    Eigen::FFT<double> fft;
    std::vector<std::complex<double>> spectrum;
    fft.fwd(spectrum, white);
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      const auto line = static_cast<double>(std::min(i, spectrum.size() - i));
      spectrum[i] *= line > 0.0 ? 1.0 / std::sqrt(line) : 0.0;
    }
    fft.inv(white, spectrum);
  } else if (p.anti_alias > 0.0) {
    for (const double quality : {0.541196, 1.306563}) {  // two stages of a fourth-order Butterworth filter
      const double t = std::tan(element::kPi * p.anti_alias);
      const double n = 1.0 / (1.0 + t / quality + t * t);
      double x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0;
      for (double& x : white) {
        const double y =
            t * t * n * (x + 2.0 * x1 + x2) - 2.0 * (t * t - 1.0) * n * y1 - (1.0 - t / quality + t * t) * n * y2;
        x2 = x1;
        x1 = x;
        y2 = y1;
        y1 = y;
        x = y;
      }
    }
  }
  const Eigen::VectorXd noise = Eigen::Map<Eigen::VectorXd>(white.data() + (p.pink ? 0 : 200), count);
  if (p.pink || p.anti_alias > 0.0) {
    return noise / std::sqrt(Eigen::Map<Eigen::VectorXd>(white.data(), static_cast<Eigen::Index>(white.size()))
                                 .array()
                                 .square()
                                 .mean());
  }
  return noise;
}

/// Interpolates with the cubic through four samples.
inline double between(const Eigen::VectorXd& values, double at) {
  const Eigen::Index left = std::clamp(static_cast<Eigen::Index>(std::floor(at)), Eigen::Index{1}, values.size() - 3);
  const double s = at - static_cast<double>(left);
  return -s * (s - 1.0) * (s - 2.0) / 6.0 * values[left - 1] + (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0 * values[left] -
         (s + 1.0) * s * (s - 2.0) / 2.0 * values[left + 1] + (s + 1.0) * s * (s - 1.0) / 6.0 * values[left + 2];
}

inline double spread(const Eigen::VectorXd& v) { return v.maxCoeff() - v.minCoeff(); }

inline void addSpikes(Eigen::VectorXd& values, double size, std::mt19937& generator, std::vector<Eigen::Index>& at) {
  std::uniform_real_distribution<double> uniform(0.05, 0.95);
  for (int i = 0; i < 3; ++i) {
    const auto place = static_cast<Eigen::Index>(uniform(generator) * static_cast<double>(values.size()));
    values.segment(place, 1 + i % 2).array() += (i % 2 == 0 ? 1.0 : -1.0) * size;
    at.push_back(place);
  }
}

/// Simulates the rig and returns its log with the errors of the bench.
inline VirtualLog runRig(const VirtualRig& rig, const Perturbation& p = {}, const std::string& name = "log") {
  constexpr double kBefore = 4.3;  // motion before a log that starts in motion [s]
  const double lead = p.running_start ? kBefore : 0.0;
  const auto count = static_cast<Eigen::Index>(rig.duration * rig.sampling);
  const auto before = static_cast<Eigen::Index>(lead * rig.sampling);
  const double dt = 1.0 / rig.sampling;
  // A log that starts in motion also ends in motion.
  const Programme programme(rig.motion, rig.seed, rig.duration + 2.0 * lead);
  const Eigen::Index fine = before + count + 8;
  Eigen::VectorXd z(fine);
  for (Eigen::Index i = 0; i < fine; ++i) {
    z[i] = 0.002 * rig.length * programme(static_cast<double>(i) * dt);
  }
  const Eigen::VectorXd f = simulateAll(elementsOf(rig), {dt * rig.time}, {z}).front();
  Eigen::VectorXd displacement(count);
  Eigen::VectorXd force(count);
  VirtualLog result;
  result.delay = p.delay * dt * rig.time;
  const double middle = 0.5 * static_cast<double>(count - 1);
  for (Eigen::Index i = 0; i < count; ++i) {
    displacement[i] = z[before + i];
    const double late = p.delay + p.clock * (static_cast<double>(i) - middle);
    const double at = std::clamp(static_cast<double>(before + i) - late, 0.0, static_cast<double>(fine - 2));
    force[i] = between(f, at);
  }
  if (p.running_start) {
    const double rest = simulateAll(elementsOf(rig), {dt * rig.time}, {displacement}).front()[0];
    result.transient = force[0] - rest;
  }
  const double range = spread(force);
  const double stroke = spread(displacement);
  const double deviation = std::sqrt((force.array() - force.mean()).square().mean());
  std::mt19937 generator(rig.seed * 7919u + 131u * static_cast<unsigned>(rig.motion) +
                         17u * static_cast<unsigned>(rig.law));
  result.force_zero = p.force_zero * range;
  result.displacement_zero = p.displacement_zero * stroke;
  const Eigen::VectorXd noise =
      rig.noise * deviation *
      unitNoise(count, p,
                rig.seed * 104729u + 31u * static_cast<unsigned>(rig.motion) + 7u * static_cast<unsigned>(rig.law));
  result.noise = std::sqrt((noise.array() - noise.mean()).square().mean());
  force = (1.0 + p.gain) * force + noise;
  force.array() += result.force_zero;
  displacement.array() += result.displacement_zero;
  if (p.clipped > 0.0) {
    force = force.cwiseMin(force.maxCoeff() - p.clipped * range);
  }
  if (p.held > 0) {
    std::uniform_real_distribution<double> uniform(0.2, 0.8);
    for (int i = 0; i < 3; ++i) {
      const auto place = static_cast<Eigen::Index>(uniform(generator) * static_cast<double>(count));
      force.segment(place, p.held).setConstant(force[place]);
    }
  }
  if (p.spikes > 0.0) {
    addSpikes(force, p.spikes * range, generator, result.spikes);
    addSpikes(displacement, p.spikes * stroke, generator, result.spikes);
  }
  force *= (p.sign ? -1.0 : 1.0) * p.factor;
  if (p.swapped) {
    std::swap(force, displacement);
  }
  result.log.name = name;
  for (Eigen::Index i = 0; i < count; ++i) {
    result.log.stamp.push_back(std::llround(static_cast<double>(i) * dt * rig.time * 1e9));
    result.log.displacement.push_back(displacement[i]);
    result.log.force.push_back(force[i]);
  }
  return result;
}

}  // namespace rubber_suspension::measurement
