// Properties of a log alone: the stiffness and the work of its loops, and channels that measured nothing.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace rubber_suspension::measurement {

/// Stiffness from the median of slopes between samples that are a quarter or half of a typical cycle apart. Offsets,
/// drifts, bump stops and spikes hardly affect this median.
struct Slope {
  double stiffness = 0.0;    ///< [N/m]
  double correlation = 0.0;  ///< correlation of the differences of force and displacement
};

Slope slopeOf(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

/// Returns 2 pi times a typical frequency in cycles per sample: the RMS step over the standard deviation.
double typicalPhase(const Eigen::VectorXd& displacement);

/// Spectrum of displacement and force in one window over one octave, from the lines that the displacement excites.
struct Octave {
  double frequency = 0.0;          ///< cycles per sample
  std::complex<double> cross = 0;  ///< cross-spectrum conj(Z) F of displacement Z and force F
  double power = 0.0;              ///< power |Z|^2 of the displacement
};

/// Cross-spectrum over half-overlapped Hann windows of a quarter of the log.
class CrossSpectrum {
 public:
  CrossSpectrum(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

  /// Returns the net work of the loops over the largest possible work, with the force shifted forward by some samples,
  /// and the standard deviation of this ratio (jackknife over windows). Dissipated work is positive.
  std::pair<double, double> work(double forward) const;

  std::vector<Octave> octaves() const;

 private:
  void add(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

  std::vector<std::vector<Octave>> windows_;
};

/// Returns the distance (0 to 2) between measured and hypothetical phases, weighted by |cross| times frequency.
template <class Phase>
double phaseDistance(const std::vector<Octave>& measured, const std::vector<Octave>& simulated, Phase phase) {
  double distance = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < std::min(measured.size(), simulated.size()); ++i) {
    const double weight = std::abs(measured[i].cross) * measured[i].frequency;
    if (weight > 0.0 && std::abs(simulated[i].cross) > 0.0) {
      const double expected = phase(std::arg(simulated[i].cross), measured[i].frequency);
      distance += weight * (1.0 - std::cos(std::arg(measured[i].cross) - expected));
      weights += weight;
    }
  }
  return weights > 0.0 ? distance / weights : 2.0;
}

/// A part of a log in which a channel stands still while the other continues as before.
struct DeadPart {
  Eigen::Index begin = 0;
  Eigen::Index end = 0;  ///< one past the last sample; equal to `begin` if there is no such part
};

/// Returns the longest part of at least a tenth of the log in which `channel` stands still while `other` swings by more
/// than `least_of_other` of the deviation of `other` in the rest of the log. This excludes holds and free play.
DeadPart deadPart(const Eigen::VectorXd& channel, const Eigen::VectorXd& other, double least_of_other);

/// Returns true if the force during a part with constant displacement exceeds hum. Hum continues in a hold; it is the
/// part of the force that follows neither displacement nor rate in the rest of the log.
bool isOfAMotion(const Eigen::VectorXd& force, const Eigen::VectorXd& displacement, const DeadPart& dead);

/// Returns the correlation of two signals about their means; 0 if either does not vary.
double correlationOf(const Eigen::VectorXd& one, const Eigen::VectorXd& other);

}  // namespace rubber_suspension::measurement
