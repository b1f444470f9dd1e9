// The verdicts of a diagnosis.
#pragma once

#include <iosfwd>
#include <string>

namespace rubber_suspension::diagnosis {

enum class Verdict {
  none,             ///< no gap beyond noise
  parameter_error,  ///< the model's own values are wrong, and nothing is missing
  named,            ///< effects of the list are missing
  confounded,       ///< effects of the list are missing, but the logs do not decide which
  unknown,          ///< an effect that is not in the list is missing
  partly,           ///< effects of the list and an effect that is not in the list are missing
  check_bench,      ///< a log has a wrong sign, unit, column or component
  defect            ///< the report would contradict itself and therefore states no result
};

/// Returns the word that reports use for a verdict.
std::string toString(Verdict verdict);

/// Returns the verdict that a word of reports stands for. Throws std::invalid_argument for any other word.
Verdict verdictOf(const std::string& word);

std::ostream& operator<<(std::ostream& stream, Verdict verdict);

/// Returns true for verdicts that name effects.
bool namesEffects(Verdict verdict);

/// Returns true for verdicts that report a residual force of unknown cause.
bool leavesRest(Verdict verdict);

}  // namespace rubber_suspension::diagnosis
