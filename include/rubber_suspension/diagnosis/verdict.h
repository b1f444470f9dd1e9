// The verdicts of a diagnosis. Throws nothing but what its functions say.
#pragma once

#include <iosfwd>
#include <string>

namespace rubber_suspension::diagnosis {

enum class Verdict {
  none,             ///< no gap beyond noise
  parameter_error,  ///< the model's own values are wrong, and nothing is missing
  named,            ///< effects of the list are missing
  confounded,       ///< likewise, but the logs do not decide which
  unknown,          ///< something is missing, and it is not in the list
  partly,           ///< effects of the list are missing, and something else
  check_bench,      ///< a log has a wrong sign, unit, column or component
  defect            ///< the report would contradict itself, and states no result
};

/// Returns the word of reports.
std::string toString(Verdict verdict);

/// Throws std::invalid_argument for a word that no report has.
Verdict verdictOf(const std::string& word);

std::ostream& operator<<(std::ostream& stream, Verdict verdict);

/// True for verdicts that name effects.
bool namesEffects(Verdict verdict);

/// True for verdicts with a residual of unknown cause.
bool leavesRest(Verdict verdict);

}  // namespace rubber_suspension::diagnosis
