// The interface of each model family to the estimation: why a specification has no solution, and the elements if it has
// one.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// The reason why a specification has no solution.
struct Obstacle {
  std::string key;     ///< the input that is named first
  std::string reason;  ///< continues "key: value ..."
};

/// Returns the loss angle at the nominal frequency [rad], from loss_angle or from relative_damping D = tan(delta)/2
/// (Polach Eq. 10); nullopt without either.
std::optional<double> specifiedLossAngle(const Specification& specification);

/// Returns the loss angle of a specification that has one [rad].
inline double lossAngle(const Specification& specification) { return specifiedLossAngle(specification).value(); }

/// Checks the stiffnesses, for all models: K_st < K_n < K_max, and none more than ten times K_st.
std::optional<Obstacle> stiffnessObstacle(const Specification& specification);

/// Checks that no stiffness is more than ten times the static one, unless the specification describes a base.
std::optional<Obstacle> ratioObstacle(const Specification& specification);

/// Returns the specification with the tangent of its curve at the working point in place of the curve.
Specification tangentOf(Model model, const Specification& specification);

/// Returns true if the numbers of a base, which pass checkSpecification(), have a solution.
bool isSolvable(Model model, const Specification& specification);

/// Returns the elements of a model with its static curve in place of the spring and, if the curve scales, with Maxwell
/// elements and dashpots in proportion to its slope over that at the working point [m].
std::vector<element::ElementDescription> alongCurve(const StaticCurve& curve, double nominal_displacement,
                                                    std::vector<element::ElementDescription> elements);

/// Returns the curve as an element.
element::ElementDescription springOf(const StaticCurve& curve);

/// Returns K*(f) [N/m] of the elements of a linear model at a frequency [Hz].
std::complex<double> stiffnessAt(const std::vector<element::ElementDescription>& elements, double frequency);

/// Returns the stiffness [N/m] of an elastic law about a displacement [m].
double slopeAbout(const element::ParallelElement& law, double displacement);

/// Returns "key: 4.2e+06 N/m", for reasons that compare two inputs.
std::string inputText(const Specification& specification, const std::string& key);

/// Returns all inputs as one line of a component file.
std::string flowMap(const Specification& specification);

/// Throws std::invalid_argument for a value that its table does not accept.
void checkRange(const element::ParameterInfo& input, double value);

/// Returns the input, or the default of its table.
double valueOrDefault(const Specification& specification, std::string_view key);

/// Returns the break frequency [Hz] at which one Maxwell element of K_max - K_st meets K_n:
/// f_b = f_n sqrt((K_max^2 - K_n^2)/(K_n^2 - K_st^2)).
double breakFrequencyForMaximum(const Specification& specification);

/// Returns the largest tolerance of any number of the sheet; the usual one if it has no number.
double largestTolerance(const Specification& specification);

/// Returns the break frequency [Hz] at which one Maxwell element meets both K_n and the loss angle: f_b = f_n K_n
/// sin(delta)/(K_n cos(delta) - K_st), because its loss over its storage stiffness is f_b/f_n.
double breakFrequencyForLossAngle(const Specification& specification);

/// Returns the break frequency [Hz] at which one Maxwell element meets K_n at f_n and high_frequency_stiffness at f_h;
/// not finite if none does.
double breakFrequencyForHighStiffness(const Specification& specification);

/// Returns |K*(f_h)| [N/m] of one Maxwell element of this break frequency [Hz] that meets K_n.
double highStiffnessOfOne(const Specification& specification, double break_frequency);

/// Checks high_frequency_stiffness against the other inputs: f_n < f_h, K_n < K(f_h).
std::optional<Obstacle> highFrequencyObstacle(const Specification& specification);

/// Checks that the storage stiffness K_n cos(delta) exceeds K_st; otherwise a Maxwell element has no stiffness.
std::optional<Obstacle> storageObstacle(const Specification& specification);

// M1 to M3 and one element of M2 (linear_models.cpp).
std::optional<Obstacle> maxwellObstacle(const Specification& specification);
std::optional<Obstacle> maxwellDashpotObstacle(const Specification& specification);
std::vector<element::ElementDescription> estimateKelvinVoigt(const Specification& specification);
std::vector<element::ElementDescription> estimateMaxwell(const Specification& specification);
std::vector<element::ElementDescription> estimateMaxwellDashpot(const Specification& specification);

// M4 to M6 (friction_models.cpp).
std::optional<Obstacle> frictionObstacle(const Specification& specification);
std::optional<Obstacle> frictionDashpotObstacle(const Specification& specification);
std::optional<Obstacle> bergObstacle(const Specification& specification);
std::vector<element::ElementDescription> estimateFriction(const Specification& specification);
std::vector<element::ElementDescription> estimateFrictionDashpot(const Specification& specification);
std::vector<element::ElementDescription> estimateBerg(const Specification& specification);

// M2 with n_M elements (multi_maxwell.cpp).
std::optional<Obstacle> multiMaxwellObstacle(const Specification& specification);
std::vector<element::ElementDescription> estimateMultiMaxwell(const Specification& specification);

/// Returns the Maxwell elements of a band (high_frequency, low_frequency, maxwell_elements) with this sum of their
/// stiffnesses [N/m] and this alpha.
std::vector<element::ElementDescription> multiMaxwellElements(const Specification& band, double relaxing, double alpha);

/// The frequencies [Hz] over which the Maxwell elements are spread.
struct Band {
  double low_frequency;
  double high_frequency;
};
Band multiMaxwellBand(const Specification& specification);

}  // namespace rubber_suspension::estimation
