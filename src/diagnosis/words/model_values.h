// The model's own values: which of them the logs contradict, and in what words.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// A value that the fit would have moved on: it is not told what it is.
bool isAtBound(const SizedValue& size);

/// Distance of a value from the configured one, as the size of the logarithm of their ratio.
double farOff(const SizedValue& size);

/// True for a value of the rubber: no band of frequencies, which is chosen, and no value at a bound of the fit.
bool mayBeHeadline(const SizedValue& size);

/// Values of the model that differ from the component file by 2 % or more with an interval that leaves the configured
/// one out; the farthest off first.
std::vector<const SizedValue*> changedValues(const Diagnosis& diagnosis);

/// The first of them that may be the headline; null where there is none.
const SizedValue* headlineValue(const Diagnosis& diagnosis);

/// "At 4 Hz and 0.35 mm (median amplitude of the logs) the whole component has K = 2.43 kN/mm (2.5 kN/mm as configured)
/// and a loss angle of 5.1 deg (4.2 deg)."; empty where nothing is known of it.
std::string wholeText(const Diagnosis& diagnosis);

/// A value of the model by the symbol of a sheet, or its element: "K_n", "maxwell 3 stiffness".
std::string valueName(const SizedValue& size);

/// "K_n is 19 % too low in the component file (3.4 kN/mm instead of 4.2 kN/mm)".
std::string offText(const SizedValue& size);

/// A number with its sign and side in words: "falls by 0.6 %/K", "31 N in compression".
std::string signedQuantity(const Diagnosis& diagnosis, const SizedValue& size);

/// The entries that the component file gains, by type: "add: 2 times bump_stop (gap 4 mm, stiffness 3 kN/mm)".
std::vector<std::string> addedTexts(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::words
