// Changes between two reports, of two test days, say.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// An earlier report.json.
class EarlierReport {
 public:
  /// Throws std::runtime_error, one line that begins with the path, where it cannot be read or is no report of
  /// `diagnose`.
  explicit EarlierReport(const std::string& path);
  /// Verdict, gaps, sizes, rig findings and the places of the gap, each as it was and as it is. A size or finding
  /// differs where the two 95 % intervals have nothing in common; a place where its part of the gap changed by more
  /// than both noise floors together.
  Comparison compare(const Diagnosis& diagnosis) const;

 private:
  std::string path_;
  Diagnosis report_;  // of which only what is compared is known
};

/// The differences as lines for a terminal, after one that says with what was compared.
std::string toText(const Comparison& comparison);

}  // namespace rubber_suspension::diagnosis::report
