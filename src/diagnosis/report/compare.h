// Changes between two reports, for example of two test days.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// An earlier report.json.
class EarlierReport {
 public:
  /// Reads the report. Throws std::runtime_error, one line that begins with the path, if it cannot be read or is no
  /// report of `diagnose`.
  explicit EarlierReport(const std::string& path);
  /// Compares verdict, gaps, sizes, rig findings and the places of the gap. A size or finding differs if the two 95 %
  /// intervals do not overlap; a gap, or its part in a place, if it changed by more than both noise floors together.
  Comparison compare(const Diagnosis& diagnosis) const;

 private:
  std::string path_;
  Diagnosis report_;  // only with the values that are compared
};

/// Returns the differences as lines for a terminal, after a line that names the earlier report.
std::string toText(const Comparison& comparison);

}  // namespace rubber_suspension::diagnosis::report
