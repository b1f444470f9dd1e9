// Surrogate for a residual force: fitted to logs, linear in its weights, bounded.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// The operators that a residual force is made of. All of them are causal and see the share of the stroke
/// q = clamp(z, lowest, highest)/S alone:
///   - stops s_i: ds = dq, kept within +-r_i, as sliders do (Prandtl, Ishlinskii);
///   - relaxing shares m_j: dm/dt = dq/dt - m/tau_j, as of Maxwell elements;
///   - the amplitude a: da/dt = (|q| - a)/tau_a, a leaky integrator;
///   - resonators: d(x, v) = (dq - omega v dt, omega (x - 2 D v) dt), oscillators of one degree of freedom.
/// The stops, the relaxing shares and q are each multiplied by 1, q, q^2 and a, which makes odd and even functions of
/// the motion, and such as change with its amplitude. Hat functions over the range add a characteristic.
class ResidualBasis {
 public:
  static constexpr std::size_t kStops = 6;
  static constexpr std::size_t kRelaxing = 4;
  static constexpr std::size_t kResonators = 8;
  static constexpr std::size_t kStates = kStops + kRelaxing + 1;  ///< s_i, m_j, q
  static constexpr std::size_t kFactors = 4;                      ///< 1, q, q^2, a

  /// The ranges of the operators.
  struct Layout {
    double stroke = 1.0;                            ///< S [m]
    double lowest = 0.0;                            ///< of the displacements that were seen [m], at most 0
    double highest = 0.0;                           ///< of these [m], at least 0
    std::array<double, kStops> stops{};             ///< r_i [-]
    std::array<double, kRelaxing> times{};          ///< tau_j [s]
    double amplitude_time = 1.0;                    ///< tau_a [s]
    bool resonant = false;                          ///< whether there are resonators
    std::array<double, kResonators> frequencies{};  ///< omega/(2 pi) of each [Hz]
    double damping = 0.15;                          ///< D of all of them [-]
    std::size_t points = 2;                         ///< of the characteristic
  };

  explicit ResidualBasis(const Layout& layout);

  const Layout& layout() const { return layout_; }

  /// Layout of the memory. Coefficients of a step length are kept until it changes.
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

  /// Initialises the memory for a component at rest at this displacement [m], relaxed since long.
  void initialise(double displacement, double* memory) const;

  /// Advances the memory over one step: of second order in its length (the amplitude of first), and stable for any.
  void advance(const Motion& motion, double* memory) const;

  /// Number of functions: products, characteristic, resonators.
  Eigen::Index size() const;

  /// Their values [-] in that order, each 0 for a component that rests at zero. Products come state by state,
  /// resonators as x and v of each.
  void evaluate(const double* memory, Eigen::Ref<Eigen::VectorXd> values) const;

  /// Point of the characteristic at or below a share of the stroke, and how far from it to the next one [0, 1].
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
  double lowest_share_ = 0.0;  // of the stroke
  double spacing_ = 0.0;       // points of the characteristic per share of the stroke
  double last_point_ = 0.0;
  Eigen::Array<double, kStops, 1> stops_;
  Eigen::Array<double, kRelaxing, 1> rates_;         // of the relaxing shares [1/s]
  Eigen::Array<double, kResonators, 1> half_omega_;  // [1/s]
};

/// F = sum of w_n phi_n(z, ...) over the functions of a ResidualBasis, kept within the forces that it had on the logs
/// it was fitted to. So it is bounded whatever the motion is, and beyond the displacements that were seen it stays what
/// it was at their end. It has no cause and claims none; a fit of its weights is a linear least squares.
///
/// It acts beside the component, on the displacement of the actuator as it is, like parts of the rig: effects on the
/// test piece's displacement and force pass it by. So what it adds is what was measured less what was simulated.
/// Not passive: it corrects another force, downwards as well.
/// Validity: motions like those of the logs, in displacement, frequency and amplitude (docs/surrogate.md).
/// Source: stop operators, M. A. Krasnosel'skii and A. V. Pokrovskii, Systems with Hysteresis, Springer 1989; sums of
/// fading memories that are linear in their weights, S. Boyd and L. O. Chua, IEEE Trans. Circuits and Systems 32 (1985)
/// 1150-1161.
class Residual final : public ParallelElement {
 public:
  /// Forces [N] of the functions of the basis, and of all [N].
  struct Weights {
    std::vector<double> products;        ///< kStates x kFactors
    std::vector<double> characteristic;  ///< one per point
    std::vector<double> resonators;      ///< two per resonator; none without resonators
    double lowest_force = 0.0;           ///< at most 0
    double highest_force = 0.0;          ///< at least 0
  };

  /// Throws std::invalid_argument where sizes do not fit.
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
  Eigen::Array<double, ResidualBasis::kStates - 1, ResidualBasis::kFactors> products_;  // of stops, relaxing shares
  std::array<double, ResidualBasis::kFactors> of_share_{};                              // of q
  std::vector<double> characteristic_;                                                  // 0 at zero displacement
  Resonators position_ = Resonators::Zero();
  Resonators velocity_ = Resonators::Zero();
  double lowest_force_;
  double highest_force_;
};

/// The entry of a component file for a basis and the weights of its functions [N], in the order of
/// ResidualBasis::evaluate, whose sum stays within two forces [N].
ElementDescription residualDescription(const ResidualBasis& basis, const Eigen::VectorXd& weights, double lowest_force,
                                       double highest_force);

}  // namespace rubber_suspension::element
