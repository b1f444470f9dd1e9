// Cases of a trial for the judgement: evidence with the sealed label, and whether an answer is right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::blind_trial {

/// The truth in a label.
struct Truth {
  std::string kind;                  ///< single, pair, triple, mixed, none, parameter_error, unknown or machine
  std::vector<std::string> effects;  ///< at work; for a machine, one of these has to be named first
  std::vector<std::string> also;     ///< for a machine: may be named in addition
  bool unlisted = false;             ///< an effect that is not in the list is at work
  bool small = false;                ///< a gap of about 3 %
  bool bench = false;                ///< the logs have errors of a bench
};

/// The judgement's answer for a case.
struct Said {
  diagnosis::Verdict verdict = diagnosis::Verdict::none;
  std::vector<std::string> effects;
  double stated = 0.0;  ///< its probability
};

/// Returns the RMS residual of a hypothesis on the logs of the fit beyond their noise, as a gap.
double leftBeyondNoise(const diagnosis::judge::Evidence& evidence, int hypothesis);

struct TrialCase {
  std::string name;
  Truth truth;
  std::optional<diagnosis::judge::Evidence> evidence;  ///< missing if the diagnosis refused the logs or failed

  /// Returns whether re-estimation hides the effects to below 0.7 % of the force; then wrong values are right as well.
  bool isHidden() const;
  bool isRight(const Said& said) const;
  bool namesTooMuch(const Said& said) const;
  /// Returns a name such as "single, 3 %, bench", by which figures are grouped.
  std::string group() const;
};

/// Returns the finished cases of FOLDER with FOLDER_labels and FOLDER_reports beside it, as run.py writes them. Throws
/// std::runtime_error or std::invalid_argument that names the file.
std::vector<TrialCase> casesOfFolder(const std::string& folder);

}  // namespace rubber_suspension::blind_trial
