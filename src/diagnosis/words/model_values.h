// Formats the values of the model that the logs contradict.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::words {

/// Returns true if the fit ended at a bound, so that the logs do not determine the value.
bool isAtBound(const SizedValue& size);

/// Returns |ln(value / configured value)|.
double farOff(const SizedValue& size);

/// Returns false for limits of the frequency band, which the user chooses, and for values at a bound of the fit.
bool mayBeHeadline(const SizedValue& size);

/// Returns the values of the model that differ from the component file by more than 2 % and whose interval excludes the
/// configured value. The value with the largest difference comes first.
std::vector<const SizedValue*> changedValues(const Diagnosis& diagnosis);

/// Returns the first of changedValues() that may be the headline, or null if there is none.
const SizedValue* headlineValue(const Diagnosis& diagnosis);

/// Returns "At 4 Hz and 0.35 mm (median amplitude of the logs) the whole component has K = 2.43 kN/mm (2.5 kN/mm as
/// configured) and a loss angle of 5.1° (4.2°)." Returns an empty text if these values are not known.
std::string wholeText(const Diagnosis& diagnosis);

/// Returns the symbol of a value on the data sheet ("K_n"), or its element and name ("maxwell 3 stiffness").
std::string valueName(const SizedValue& size);

/// Returns a text such as "K_n is 19 % too low in the component file (3.4 kN/mm instead of 4.2 kN/mm)".
std::string offText(const SizedValue& size);

/// Returns a number whose sign is expressed in words, such as "falls by 0.6 %/K" or "31 N in compression".
std::string signedQuantity(const Diagnosis& diagnosis, const SizedValue& size);

/// Returns one text per type of the added entries, such as "add: 2 times bump_stop (gap 4 mm, stiffness 3 kN/mm)".
std::vector<std::string> addedTexts(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::words
