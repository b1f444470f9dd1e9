// Chooses the effects that are omitted from the component file.
#include "diagnosis/results/withholding.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/results/left_of_logs.h"
#include "fit/free_in_log.h"
#include "gap/simulate.h"

namespace rubber_suspension::diagnosis::results {
namespace {

using judge::Evidence;

class Withholding {
 public:
  Withholding(const hypotheses::PreparedCase& prepared, const Workings& workings,
              const std::vector<measurement::RigFinding>& findings)
      : prepared_(prepared), search_(workings.search), evidence_(workings.evidence), records_(prepared.training) {
    records_.insert(records_.end(), prepared.held_out.begin(), prepared.held_out.end());
    rig_ = rigOfLogs(records_, findings);
    const hypotheses::FittedHypothesis& judged = search_.at(workings.answer.model);
    factors_ = prepared.fitter.factors(judged.hypothesis, judged.fit.parameters);
    configured_ = forcesOf(prepared.component);
  }

  std::vector<LeftOfLog> left(const io::ComponentDescription& written) const {
    return leftOfLogs(records_, rig_, configured_, forcesOf(written));
  }

  /// Returns true if a hypothesis fits a gain or an offset to each log.
  bool differsBetweenLogs(int hypothesis) const {
    const fit::PerLogNuisances& free = search_.at(hypothesis).hypothesis.free_in_log;
    return free.gain || free.offset;
  }

  /// Returns the index of the best hypothesis with one effect fewer, or of the configured model if there is no effect.
  int without(int hypothesis) const {
    const std::vector<int>& members = evidence_.at(hypothesis).members;
    if (members.empty()) {
      return Evidence::kAsConfigured;
    }
    int best = Evidence::kReEstimated;
    double least = std::numeric_limits<double>::infinity();
    const bool of_single_logs = std::any_of(members.begin(), members.end(), [&](int m) { return isOfSingleLogs(m); });
    for (const int member : members) {
      const int rest = placeOf(members, member);
      if (rest < 0 || isOfSingleLogs(member) != of_single_logs) {
        continue;
      }
      const double excess = excessOf(left(hypotheses::augmentedDescription(prepared_.model, search_.at(rest))));
      best = excess < least ? rest : best;
      least = std::min(least, excess);
    }
    return best;
  }

 private:
  bool isOfSingleLogs(int member) const {
    return search_.candidates[static_cast<std::size_t>(member)].free_in_log.any();
  }

  // Returns the index of the hypothesis without one of its effects, or -1 if that was not fitted.
  int placeOf(std::vector<int> members, int without) const {
    members.erase(std::find(members.begin(), members.end(), without));
    const auto found = std::find_if(evidence_.hypotheses.begin() + Evidence::kReEstimated, evidence_.hypotheses.end(),
                                    [&](const auto& hypothesis) { return hypothesis.members == members; });
    return found == evidence_.hypotheses.end() ? -1 : static_cast<int>(found - evidence_.hypotheses.begin());
  }

  // Returns the forces on the logs of the fit, with the reported factors on friction, then those on the held-out logs.
  gap::Forces forcesOf(const io::ComponentDescription& description) const {
    const auto elements = description.allElements();
    gap::Forces forces = gap::simulate(elements, prepared_.training, gap::asRecorded);
    const gap::Forces friction = factors_.empty() ? gap::Forces() : fit::frictionOf(elements, prepared_.training);
    for (std::size_t r = 0; r < friction.size(); ++r) {
      forces[r] += (factors_[r] - 1.0) * friction[r];
    }
    const gap::Forces unseen = gap::simulateEach(elements, prepared_.held_out);
    forces.insert(forces.end(), unseen.begin(), unseen.end());
    return forces;
  }

  const hypotheses::PreparedCase& prepared_;
  const hypotheses::Search& search_;
  const Evidence& evidence_;
  std::vector<gap::PreparedRecord> records_;
  std::vector<RigOfLog> rig_;
  std::vector<double> factors_;
  gap::Forces configured_;
};

// Returns the names of the effects that the smaller hypothesis lacks, or "values" if it lacks none.
std::vector<std::string> lackedBy(const Evidence& evidence, int smaller, int larger) {
  std::vector<std::string> names;
  const std::vector<int>& kept = evidence.at(smaller).members;
  for (const int member : evidence.at(larger).members) {
    if (std::find(kept.begin(), kept.end(), member) == kept.end()) {
      names.push_back(evidence.effects[static_cast<std::size_t>(member)]);
    }
  }
  return names.empty() ? std::vector<std::string>{"values"} : names;
}

}  // namespace

MeasuredLaw withoutDamage(const hypotheses::PreparedCase& prepared, const Workings& workings, MeasuredLaw named,
                          double before, const std::vector<measurement::RigFinding>& findings,
                          const DiagnosisOptions& options) {
  const Withholding withholding(prepared, workings, findings);
  MeasuredLaw written = std::move(named);
  std::vector<Withheld> withheld;
  std::vector<LeftOfLog> left = withholding.left(written.law.augmented);
  int place = workings.answer.model;
  while (place != Evidence::kAsConfigured && (excessOf(left) > 0.0 || withholding.differsBetweenLogs(place))) {
    const int smaller = withholding.without(place);
    const LeftOfLog worst = worstOf(left);
    for (const std::string& effect : lackedBy(workings.evidence, smaller, place)) {
      withheld.push_back({effect, worst.log, worst.configured, worst.written});
    }
    place = smaller;
    written = writtenLaw(prepared, workings.search, workings.search.at(place), before, options);
    left = withholding.left(written.law.augmented);
  }
  written.as_configured = place == Evidence::kAsConfigured;
  written.law.withheld = std::move(withheld);
  written.law.left_of_logs = std::move(left);
  return written;
}

}  // namespace rubber_suspension::diagnosis::results
