// Formats numbers and text for reports.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Returns "these logs" or "this table", according to the source of a diagnosis.
std::string sourceOf(const Diagnosis& diagnosis);

/// Returns "7.9 %" for 0.079, and "-" for a value that is not finite.
std::string percent(double value, int decimals = 1);

/// Returns "8" for 0.079, and "0" rather than "-0".
std::string wholePercent(double value);

/// Returns a probability [%] that is never 0 or 100: "below 1", "8", "more than 99".
std::string chance(double probability);

/// Returns "a", "a and b", or "a, b and c".
std::string enumerated(const std::vector<std::string>& parts);

/// Returns "The model" for "the model".
std::string capitalised(std::string text);

/// Returns an SI value in the usual unit: "6 kN", "0.35 mm", "4.2 kN/mm".
std::string quantity(double value, const std::string& unit);

/// Returns a value with its interval in the same unit: "6 kN (5.7 to 6.4 kN)".
std::string quantity(const SizedValue& size);

/// Returns the interval of a value in the unit that suits the value: "5.7 to 6.4 kN".
std::string intervalText(const SizedValue& size);

/// Returns the interval with these texts as its limits. `unit` is empty or begins with a space.
std::string intervalText(const SizedValue& size, const std::string& least, const std::string& most,
                         const std::string& unit);

/// Replaces the units of a displacement by those of a rotation: "6 N m" for "6 N", "4 kN m/mrad" for "4 kN/mm". The
/// text must not contain names of logs, because they might look like units.
std::string inRotationUnits(const std::string& text);

/// Returns the text, with the units of a rotation if the diagnosed direction is a rotation.
std::string inUnits(const Diagnosis& diagnosis, const std::string& text);

/// Returns an SI unit, converted to the unit of a rotation if the diagnosed direction is a rotation.
std::string unitOf(const Diagnosis& diagnosis, const std::string& si);

/// Returns a band times a factor, such as "2 to 4", or "2" if both limits are equal.
std::string rangeText(const std::array<double, 2>& band, double factor);

/// Returns "dynamic stiffness" for dynamic_stiffness.
std::string spoken(const std::string& name);

/// Returns the label of a value, such as "maximum force", or with a colon if it is for one side: "gap in tension:".
std::string labelOf(const std::string& name);

/// Returns the name that stands in front of a size: the label that its effect defines (Effect::labels), or labelOf().
std::string sizeName(const SizedValue& size);

/// Returns the symbol of a value in a specification, such as "K_n" for dynamic_stiffness, or spoken() if it has none.
std::string symbolOf(const std::string& name);

/// Returns a phrase for each log, with the removed parts that are at least 1 % of the force.
std::vector<std::string> describeTakenOut(const std::vector<TakenOut>& taken_out);

}  // namespace rubber_suspension::diagnosis::words
