// The functions of each family of models: the reason why a specification has no solution, or the elements of the
// solution. Symbols are those of specification.h.
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
  std::string key;     ///< the input that the message names first
  std::string reason;  ///< continues the message "key: value ..."
};

/// Returns the loss angle at the nominal frequency [rad], from loss_angle or from relative_damping D = tan(delta)/2
/// (Polach, Eq. 10). Returns nullopt if the specification has neither.
std::optional<double> specifiedLossAngle(const Specification& specification);

/// Returns the loss angle [rad] of a specification that has one.
inline double lossAngle(const Specification& specification) { return specifiedLossAngle(specification).value(); }

/// Checks the stiffnesses of all models: K_st < K_n < K_max, none of which exceeds ten times K_st.
std::optional<Obstacle> stiffnessObstacle(const Specification& specification);

/// Checks that no stiffness exceeds ten times the static stiffness, unless the specification describes a base.
std::optional<Obstacle> ratioObstacle(const Specification& specification);

/// Returns the specification with the tangent of the static curve at the working point instead of the curve.
Specification tangentOf(Model model, const Specification& specification);

/// Returns true if the numbers of a base, which passed checkSpecification(), have a solution.
bool isSolvable(Model model, const Specification& specification);

/// Returns the elements of a model with its static curve instead of the spring. If the curve scales, Maxwell elements
/// and dashpots are proportional to the slope of the curve, relative to the slope at the working point [m].
std::vector<element::ElementDescription> alongCurve(const StaticCurve& curve, double nominal_displacement,
                                                    std::vector<element::ElementDescription> elements);

/// Returns an element with the force of the curve.
element::ElementDescription springOf(const StaticCurve& curve);

/// Returns K*(f) [N/m] of the elements of a linear model at a frequency [Hz].
std::complex<double> stiffnessAt(const std::vector<element::ElementDescription>& elements, double frequency);

/// Returns the stiffness [N/m] of an elastic law at a displacement [m].
double slopeAbout(const element::ParallelElement& law, double displacement);

/// Returns an input as text, such as "key: 4.2e+06 N/m", for messages that compare two inputs.
std::string inputText(const Specification& specification, const std::string& key);

/// Returns all inputs as a YAML map on one line, as in a component file.
std::string flowMap(const Specification& specification);

/// Throws std::invalid_argument if the table of the input does not accept the value.
void checkRange(const element::ParameterInfo& input, double value);

/// Returns the input, or its default if it is not given.
double valueOrDefault(const Specification& specification, std::string_view key);

/// Returns the break frequency [Hz] at which one Maxwell element of stiffness K_max - K_st meets K_n: f_b = f_n
/// sqrt((K_max^2 - K_n^2)/(K_n^2 - K_st^2)).
double breakFrequencyForMaximum(const Specification& specification);

/// Returns the largest tolerance of the numbers on the data sheet; the usual tolerance if the sheet has no number.
double largestTolerance(const Specification& specification);

/// Returns the break frequency [Hz] at which one Maxwell element meets K_n and the loss angle delta: f_b = f_n K_n
/// sin(delta)/(K_n cos(delta) - K_st), because its loss stiffness over its storage stiffness is f_b/f_n.
double breakFrequencyForLossAngle(const Specification& specification);

/// Returns the break frequency [Hz] at which one Maxwell element meets K_n at f_n and high_frequency_stiffness at f_h.
/// Returns a value that is not finite if no frequency does.
double breakFrequencyForHighStiffness(const Specification& specification);

/// Returns |K*(f_h)| [N/m] of one Maxwell element with this break frequency [Hz] that meets K_n.
double highStiffnessOfOne(const Specification& specification, double break_frequency);

/// Checks high_frequency_stiffness K(f_h) against the other inputs: f_n < f_h and K_n < K(f_h).
std::optional<Obstacle> highFrequencyObstacle(const Specification& specification);

/// Checks that the storage stiffness K_n cos(delta) exceeds K_st; otherwise a Maxwell element would have no stiffness.
std::optional<Obstacle> storageObstacle(const Specification& specification);

// M1 to M3, and M2 with one element (linear_models.cpp).
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

/// Returns the Maxwell elements of a band (high_frequency, low_frequency, maxwell_elements) whose stiffnesses have the
/// sum `relaxing` [N/m] and the ratio `alpha` between neighbours.
std::vector<element::ElementDescription> multiMaxwellElements(const Specification& band, double relaxing, double alpha);

/// The frequency range [Hz] over which the Maxwell elements are spread.
struct Band {
  double low_frequency;
  double high_frequency;
};
Band multiMaxwellBand(const Specification& specification);

}  // namespace rubber_suspension::estimation
