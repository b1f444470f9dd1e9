// Cases of a trial for the judgement: the evidence, the sealed label, and whether an answer is right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::blind_trial {

/// The true cause in a label.
struct Truth {
  std::string kind;                  ///< single, pair, triple, mixed, none, parameter_error, unknown or machine
  std::vector<std::string> effects;  ///< effects that act; for a rig of kind machine, one of these must be named first
  std::vector<std::string> also;     ///< effects that may be named in addition, for kind machine
  bool unlisted = false;             ///< an effect that is not in the list acts
  bool small = false;                ///< a gap of about 3 %
  bool bench = false;                ///< the logs have errors of a bench
};

/// The answer of the judgement for a case.
struct Said {
  diagnosis::Verdict verdict = diagnosis::Verdict::none;
  std::vector<std::string> effects;
  double stated = 0.0;  ///< probability that the judgement states
};

/// Returns the RMS residual of a hypothesis beyond the noise, on the logs of the fit, as a gap.
double leftBeyondNoise(const diagnosis::judge::Evidence& evidence, int hypothesis);

struct TrialCase {
  std::string name;
  std::string hand;  ///< name of the folder that contains FOLDER; its cases are written by one author
  Truth truth;
  std::optional<diagnosis::judge::Evidence> evidence;  ///< missing if the diagnosis refused the logs or failed

  /// Returns true if other values hide the effects below 0.7 % of the force, so that wrong values are a right answer
  /// too.
  bool isHidden() const;
  bool isRight(const Said& said) const;
  bool namesTooMuch(const Said& said) const;
  /// Returns a name such as "single, 3 %, bench", by which results are grouped.
  std::string group() const;
};

/// Returns the finished cases in FOLDER, FOLDER_labels and FOLDER_reports, as run.py writes them. Throws
/// std::runtime_error or std::invalid_argument with the name of the file.
std::vector<TrialCase> casesOfFolder(const std::string& folder);

}  // namespace rubber_suspension::blind_trial
