// The verdicts of a diagnosis. Throws nothing but what its functions say.
#pragma once

#include <iosfwd>
#include <string>

namespace rubber_suspension::diagnosis {

enum class Verdict {
  none,             ///< no gap beyond noise
  parameter_error,  ///< the model's own values are wrong, and nothing is missing
  named,            ///< effects of the list are missing
  confounded,       ///< likewise, and the logs cannot tell which
  unknown,          ///< something is missing, and it is not in the list
  partly,           ///< effects of the list are missing, and something else
  check_bench,      ///< a log has a wrong sign, unit, column or component
  defect            ///< the report would contradict itself, and tells nothing
};

/// As in reports.
std::string toString(Verdict verdict);

/// Throws std::invalid_argument for a word that no report has.
Verdict verdictOf(const std::string& word);

std::ostream& operator<<(std::ostream& stream, Verdict verdict);

/// True for those that name effects.
bool namesEffects(Verdict verdict);

/// True for those that leave a rest without a cause.
bool leavesRest(Verdict verdict);

}  // namespace rubber_suspension::diagnosis
