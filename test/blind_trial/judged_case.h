// Cases of a trial as the judgement sees them: evidence beside the sealed label, and whether an answer is right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::blind_trial {

/// What a label says.
struct Truth {
  std::string kind;                  ///< single, pair, triple, mixed, none, parameter_error, unknown or machine
  std::vector<std::string> effects;  ///< at work; of a machine, those of which one has to come first
  std::vector<std::string> also;     ///< of a machine: may be named besides
  bool unlisted = false;             ///< something that is not in the list is at work
  bool small = false;                ///< a gap of about 3 %
  bool bench = false;                ///< logs as benches are
};

/// What the judgement says of a case.
struct Said {
  diagnosis::Verdict verdict = diagnosis::Verdict::none;
  std::vector<std::string> effects;
  double stated = 0.0;  ///< its probability
};

/// Root mean square that a hypothesis leaves of the logs of the fit beyond their noise, as a gap.
double leftBeyondNoise(const diagnosis::judge::Evidence& evidence, int hypothesis);

struct TrialCase {
  std::string name;
  Truth truth;
  std::optional<diagnosis::judge::Evidence> evidence;  ///< none where the diagnosis refused the logs or failed

  /// Re-estimation takes the effects up, but for what is less than 0.7 % of the force: wrong values are right, too.
  bool isHidden() const;
  bool isRight(const Said& said) const;
  bool namesTooMuch(const Said& said) const;
  /// "single, 3 %, bench" and the like: what figures are given by.
  std::string group() const;
};

/// Of a folder FOLDER of cases with FOLDER_labels and FOLDER_reports beside it, those that run.py has run. Throws
/// std::runtime_error or std::invalid_argument that names the file.
std::vector<TrialCase> casesOfFolder(const std::string& folder);

}  // namespace rubber_suspension::blind_trial
