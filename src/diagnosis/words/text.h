// Numbers and text as reports have them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Returns "these logs" or "this table", the source of a diagnosis.
std::string sourceOf(const Diagnosis& diagnosis);

/// Returns "7.9 %" for 0.079, and "-" for a value that is not finite.
std::string percent(double value, int decimals = 1);

/// Returns "8" for 0.079, without a minus before 0.
std::string wholePercent(double value);

/// Returns a probability [%], never as 0 or 100: "below 1", "more than 99".
std::string chance(double probability);

/// Returns "a", "a and b", or "a, b and c".
std::string enumerated(const std::vector<std::string>& parts);

/// Returns "The model" for "the model".
std::string capitalised(std::string text);

/// Returns a value in SI with the usual prefix: "6 kN", "0.35 mm", "4.2 kN/mm".
std::string quantity(double value, const std::string& unit);

/// Returns a value with its interval in the same unit: "6 kN (5.7 to 6.4 kN)".
std::string quantity(const SizedValue& size);

/// Returns the interval of a value in the unit of the value: "5.7 to 6.4 kN".
std::string intervalText(const SizedValue& size);

/// Returns the interval with these texts as its ends; `unit` begins with a space or is empty.
std::string intervalText(const SizedValue& size, const std::string& least, const std::string& most,
                         const std::string& unit);

/// Replaces the units of a displacement by those of a rotation: "6 N m" for "6 N", "4 kN m/mrad" for "4 kN/mm". Only
/// for texts of the package, because names of logs might look like units.
std::string inRotationUnits(const std::string& text);

/// Returns the text with the units of a rotation if the diagnosis is of one.
std::string inUnits(const Diagnosis& diagnosis, const std::string& text);

/// Returns a unit of a displacement [SI], converted to that of a rotation if the diagnosis is of one.
std::string unitOf(const Diagnosis& diagnosis, const std::string& si);

/// Returns "2 to 4" for a band times a factor, "2" if both ends are equal.
std::string rangeText(const std::array<double, 2>& band, double factor);

/// Returns "dynamic stiffness" for dynamic_stiffness.
std::string spoken(const std::string& name);

/// Returns the label of a value, with a colon if it is of one side: "maximum force", "gap in tension:".
std::string labelOf(const std::string& name);

/// Returns the name of a size in front of its value: that of its effect (Effect::labels), or else labelOf().
std::string sizeName(const SizedValue& size);

/// Returns the symbol of a value in a specification, if it has one, or else spoken(): "K_n" for dynamic_stiffness.
std::string symbolOf(const std::string& name);

/// Returns a phrase for each log with the parts removed from it that are more than a hundredth of the force.
std::vector<std::string> describeTakenOut(const std::vector<TakenOut>& taken_out);

}  // namespace rubber_suspension::diagnosis::words
