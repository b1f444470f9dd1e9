// Compares two reports, for example of two test days.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

class EarlierReport {
 public:
  /// Reads the report. Throws std::runtime_error of one line if it cannot be read or is no report of `diagnose`.
  explicit EarlierReport(const std::string& path);
  /// Compares verdict, gaps, sizes, findings about the rig and where the gap lies. Two sizes or findings differ if
  /// their 95 % intervals do not overlap. Two gaps (or parts of gaps) differ if their difference exceeds the sum of
  /// both noise floors.
  Comparison compare(const Diagnosis& diagnosis) const;

 private:
  std::string path_;
  Diagnosis report_;  // contains only the values that are compared
};

/// Returns the differences as lines for a terminal. The first line names the earlier report.
std::string toText(const Comparison& comparison);

}  // namespace rubber_suspension::diagnosis::report
