// What one rig does to all types that are tested on it: a rig that gives way softens a stiff type more than a soft one,
// which no single type can tell from wrong values of its own.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace rubber_suspension::campaign {

/// Components of one type, by numbers of the specification that are stiffnesses; the same numbers for every type.
struct TypeOnRig {
  std::vector<double> stiffness;                ///< configured [N/m]
  std::vector<std::vector<double>> logarithms;  ///< of re-estimated over configured value; a row for each component
};

enum class RigCause {
  none,       ///< the configured values hold for all types
  factor,     ///< all types are off by one factor: a gain of the rig, or a unit
  own,        ///< each type has wrong values of its own
  compliance  ///< the rig gives way: 1/measured = 1/true + compliance, for every stiffness of every type
};

constexpr std::size_t kRigCauses = 4;

struct RigJudgement {
  std::array<double, kRigCauses> probabilities{};  ///< by RigCause
  double compliance = 0.0;                         ///< if it is that [m/N]
  double compliance_error = 0.0;                   ///< its standard deviation
  std::array<double, 2> compliance_interval{};     ///< 95 %

  double probability(RigCause cause) const { return probabilities.at(static_cast<std::size_t>(cause)); }
};

/// Types have to differ by this factor in stiffness: else they say alike of a factor and of a compliance.
constexpr double kLeastLever = 1.5;

/// Probabilities of the four causes, each as likely as the others before. The mean logarithms of a type have a normal
/// distribution, with the covariance between its components over their number, and 1 % by which any specification errs.
/// A factor, and the values of a type of its own, err by 7 %, half of what a specification errs by
/// (Criteria::values_err_by); a compliance takes about 14 % of the stiffest type. Nothing for fewer than two types of
/// kFewestComponents, or types of the same stiffness.
std::optional<RigJudgement> judgeRig(const std::vector<TypeOnRig>& types);

/// Standard deviation of the logarithm of a rig's gain, which all components on it share: the usual tolerance of 0.5 %
/// (io::RigTolerances) as two of them.
constexpr double kGainError = 0.0025;

/// Logarithm of true over configured stiffness, of that of measured over configured, behind a compliance [m/N]; nothing
/// where the compliance alone would be softer than what was measured.
std::optional<double> withoutCompliance(double logarithm, double configured, double compliance);

}  // namespace rubber_suspension::campaign
