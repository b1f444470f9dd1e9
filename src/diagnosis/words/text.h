// Numbers and text as reports have them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// "these logs" or "this table": what a diagnosis was made from.
std::string sourceOf(const Diagnosis& diagnosis);

/// "7.9 %" of 0.079.
std::string percent(double value, int decimals = 1);

/// "8" of 0.079, without a minus before 0.
std::string wholePercent(double value);

/// Text of a probability, which is never 0 nor certain: "below 1", "more than 99".
std::string chance(double probability);

/// "a", "a and b", "a, b and c".
std::string enumerated(const std::vector<std::string>& parts);

/// "The model" of "the model".
std::string capitalised(std::string text);

/// A value in SI with the prefix that an engineer reads: "6 kN", "0.35 mm", "4.2 kN/mm".
std::string quantity(double value, const std::string& unit);

/// Value with its interval in the same unit: "6 kN (5.7 to 6.4 kN)".
std::string quantity(const SizedValue& size);

/// Its interval alone, in the unit of its value: "5.7 to 6.4 kN".
std::string intervalText(const SizedValue& size);

/// Interval with ends that are text; the unit with its space, or empty.
std::string intervalText(const SizedValue& size, const std::string& least, const std::string& most,
                         const std::string& unit);

/// Words of the package's own, in which a rotation was taken for a displacement, with its units: "6 N m" for "6 N", "4
/// kN m/mrad" for "4 kN/mm". Not for what has names of logs in it.
std::string inRotationUnits(const std::string& text);

/// Text with the units of a rotation if the diagnosis is of one.
std::string inUnits(const Diagnosis& diagnosis, const std::string& text);

/// The unit of what is in this one [SI] where a displacement is diagnosed.
std::string unitOf(const Diagnosis& diagnosis, const std::string& si);

/// "2 to 4" of a band times a factor, "2" where both ends are one.
std::string rangeText(const std::array<double, 2>& band, double factor);

/// "dynamic stiffness" of dynamic_stiffness.
std::string spoken(const std::string& name);

/// Label of a value: "maximum force", but "gap in tension:" of one side.
std::string labelOf(const std::string& name);

/// The name of a size in front of its value: that of its effect (Effect::labels), or else labelOf().
std::string sizeName(const SizedValue& size);

/// The symbol of a value in a specification, where it has one: "K_n" of dynamic_stiffness, else spoken().
std::string symbolOf(const std::string& name);

/// The parts taken out of logs that are more than a hundredth of the force, a phrase for each log; empty where there
/// are none.
std::vector<std::string> describeTakenOut(const std::vector<TakenOut>& taken_out);

}  // namespace rubber_suspension::diagnosis::words
