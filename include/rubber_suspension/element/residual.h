// Surrogate for a residual force: fitted to logs, linear in its weights, bounded.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Evaluates the functions whose weighted sum is a residual force. They consist of causal operators, whose only input
/// is the displacement in strokes, q = clamp(z, lowest, highest)/S:
///   - stops s_i: ds = dq, clamped to +-r_i, as in sliders (Prandtl, Ishlinskii);
///   - relaxing shares m_j: dm/dt = dq/dt - m/tau_j, as in Maxwell elements;
///   - the amplitude a: da/dt = (|q| - a)/tau_a, a leaky integrator;
///   - resonators: d(x, v) = (dq - omega v dt, omega (x - 2 D v) dt), oscillators of one degree of freedom.
/// The stops, the relaxing shares and q are each multiplied by 1, q, q^2 and a, which gives odd and even functions of
/// the motion and functions that change with its amplitude. Hat functions of the displacement add a static
/// characteristic.
class ResidualBasis {
 public:
  static constexpr std::size_t kStops = 6;
  static constexpr std::size_t kRelaxing = 4;
  static constexpr std::size_t kResonators = 8;
  static constexpr std::size_t kStates = kStops + kRelaxing + 1;  ///< s_i, m_j, q
  static constexpr std::size_t kFactors = 4;                      ///< 1, q, q^2, a

  /// Parameters of the operators.
  struct Layout {
    double stroke = 1.0;                            ///< S [m]
    double lowest = 0.0;                            ///< lowest displacement in the logs [m], at most 0
    double highest = 0.0;                           ///< highest displacement in the logs [m], at least 0
    std::array<double, kStops> stops{};             ///< r_i [-]
    std::array<double, kRelaxing> times{};          ///< tau_j [s]
    double amplitude_time = 1.0;                    ///< tau_a [s]
    bool resonant = false;                          ///< true if there are resonators
    std::array<double, kResonators> frequencies{};  ///< omega/(2 pi) of each resonator [Hz]
    double damping = 0.15;                          ///< D of all resonators [-]
    std::size_t points = 2;                         ///< number of points of the characteristic
  };

  explicit ResidualBasis(const Layout& layout);

  const Layout& layout() const { return layout_; }

  /// Layout of the memory. The coefficients of a step are kept until the step length changes.
  enum Slot : std::size_t {
    kStop,
    kRelaxed = kStop + kStops,
    kShare = kRelaxed + kRelaxing,
    kAmplitude,
    kPosition,
    kVelocity = kPosition + kResonators,
    kStepLength = kVelocity + kResonators,
    kAmplitudeDecay,
    kDecay,
    kMean = kDecay + kRelaxing,
    kTurn = kMean + kRelaxing,  // five coefficients of each resonator
    kMemorySize = kTurn + 5 * kResonators,
  };

  /// Initialises the memory for a component at rest and fully relaxed at this displacement [m].
  void initialise(double displacement, double* memory) const;

  /// Advances the memory over one step. The error is of second order (for the amplitude of first order); steps of any
  /// length are stable.
  void advance(const Motion& motion, double* memory) const;

  /// Returns the number of functions: the products, the points of the characteristic, and two for each resonator.
  Eigen::Index size() const;

  /// Computes the values [-] of the functions: the products state by state, the points of the characteristic, x and v
  /// of each resonator. All values are 0 for a component at rest at zero displacement.
  void evaluate(const double* memory, Eigen::Ref<Eigen::VectorXd> values) const;

  /// A position on the characteristic: the point below the position, and the share [0, 1] of the distance to the next
  /// point.
  struct Place {
    Eigen::Index point;
    double share;
  };
  Place placeOf(double share_of_stroke) const;

 private:
  double shareOf(double displacement) const;
  void prepare(double dt, double* memory) const;
  void prepareResonators(double dt, double* memory) const;

  Layout layout_;
  double per_stroke_;          // 1/S [1/m]
  double lowest_share_ = 0.0;  // lowest displacement/S [-]
  double spacing_ = 0.0;       // points of the characteristic per stroke
  double last_point_ = 0.0;
  Eigen::Array<double, kStops, 1> stops_;
  Eigen::Array<double, kRelaxing, 1> rates_;         // 1/tau_j [1/s]
  Eigen::Array<double, kResonators, 1> half_omega_;  // [1/s]
};

/// Simulates F = sum of w_n phi_n(z, ...) over the functions of a ResidualBasis, clamped to the range that this sum has
/// on the logs to which it was fitted. So the force is bounded for any motion, and a displacement outside the range of
/// the logs acts like the end of that range. The law is a surrogate without a cause. Its weights are fitted by linear
/// least squares.
///
/// The force acts in parallel with the component, on the displacement of the actuator, as parts of the rig do. Effects
/// on the displacement and force of the test piece do not change it, so it can stand for measured minus simulated
/// force. The law is not passive, because its force may reduce another force. Validity: motions like those of the logs,
/// in displacement, frequency and amplitude (docs/surrogate.md). Source: stop operators, M. A. Krasnosel'skii and A. V.
/// Pokrovskii, Systems with Hysteresis, Springer 1989; sums of fading memories that are linear in their weights, S.
/// Boyd and L. O. Chua, IEEE Trans. Circuits and Systems 32 (1985) 1150-1161.
class Residual final : public ParallelElement {
 public:
  /// Weights of the functions of the basis and bounds of their sum, all [N].
  struct Weights {
    std::vector<double> products;        ///< kStates x kFactors weights
    std::vector<double> characteristic;  ///< one weight per point
    std::vector<double> resonators;      ///< two weights per resonator; may be empty
    double lowest_force = 0.0;           ///< lower bound of the sum, at most 0
    double highest_force = 0.0;          ///< upper bound of the sum, at least 0
  };

  /// Throws std::invalid_argument if the numbers of weights do not match the layout, or the layout is out of range.
  Residual(const ResidualBasis::Layout& layout, const Weights& weights);

  std::size_t memorySize() const override { return ResidualBasis::kMemorySize; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }
  bool onRig() const override { return true; }
  bool passive() const override { return false; }

 private:
  double force(const double* memory) const;

  using Resonators = Eigen::Array<double, ResidualBasis::kResonators, 1>;

  ResidualBasis basis_;
  Eigen::Array<double, ResidualBasis::kStates - 1, ResidualBasis::kFactors> products_;  // weights of s_i and m_j
  std::array<double, ResidualBasis::kFactors> of_share_{};                              // weights of q
  std::vector<double> characteristic_;                                                  // 0 at zero displacement
  Resonators position_ = Resonators::Zero();
  Resonators velocity_ = Resonators::Zero();
  double lowest_force_;
  double highest_force_;
};

/// Returns the entry of a component file for a basis, the weights [N] of its functions in the order of
/// ResidualBasis::evaluate, and the bounds [N] of their sum.
ElementDescription residualDescription(const ResidualBasis& basis, const Eigen::VectorXd& weights, double lowest_force,
                                       double highest_force);

}  // namespace rubber_suspension::element
