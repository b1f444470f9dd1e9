// Properties of a log alone: the stiffness and the work of its loops, and which of its channels measured nothing.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace rubber_suspension::measurement {

/// Stiffness over a quarter and half of a typical cycle: median of the slopes between pairs of samples, so that neither
/// offsets and drifts nor bump stops and spikes count.
struct Slope {
  double stiffness = 0.0;    ///< [N/m]
  double correlation = 0.0;  ///< of both differences
};

Slope slopeOf(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

/// 2 pi times a typical frequency, per sample.
double typicalPhase(const Eigen::VectorXd& displacement);

/// Displacement and force over octaves where the displacement is, in one window.
struct Octave {
  double frequency = 0.0;          ///< cycles per sample
  std::complex<double> cross = 0;  ///< conj(Z) F
  double power = 0.0;              ///< |Z|^2
};

/// Cross-spectrum: mean over all half-overlapped Hann windows of a quarter of the log.
class CrossSpectrum {
 public:
  CrossSpectrum(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

  /// Net work of the loops, as a share of the most that there could be, with the force brought forward by some samples:
  /// positive where they take energy; its standard deviation by leaving out one window after the other.
  std::pair<double, double> work(double forward) const;

  std::vector<Octave> octaves() const;

 private:
  void add(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

  std::vector<std::vector<Octave>> windows_;
};

/// Distance of measured phases from those of a hypothesis, 0 to 2, weighted by the force.
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
  Eigen::Index end = 0;  ///< one behind; as begin: there is none
};

/// The longest part of at least a tenth of the log. A hold is none, for the force relaxes in it, nor is a displacement
/// within a free play, which is smaller than that of the rest.
DeadPart deadPart(const Eigen::VectorXd& channel, const Eigen::VectorXd& other, double least_of_other);

/// True if the force at a dead displacement exceeds its part that no motion causes, such as hum, which continues in a
/// hold: what follows neither displacement nor rate in the rest of the log.
bool isOfAMotion(const Eigen::VectorXd& force, const Eigen::VectorXd& displacement, const DeadPart& dead);

/// Correlation of two signals about their means; 0 where one does not change.
double correlationOf(const Eigen::VectorXd& one, const Eigen::VectorXd& other);

}  // namespace rubber_suspension::measurement
