// What no motion causes, taken for noise.
#include "diagnosis/judge/rest_as_noise.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/further_logs.h"
#include "diagnosis/judge/weighing.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

bool isFunctionOfMotion(const HypothesisEvidence& hypothesis) {
  return !hypothesis.members.empty() && !hypothesis.sensor;
}

// What the best function of the motion leaves of a gap above a floor, as a new floor.
double floorOf(double gap, double floor, double caused_by_motion, double least, double margin) {
  const double left = gap::residualAboveFloor(gap, floor) * std::sqrt(1.0 - caused_by_motion);
  return std::max(floor, std::min(std::hypot(left, floor), least) / margin);
}

}  // namespace

bool motionCausesSmallerPart(const Evidence& evidence, const Criteria& criteria) {
  return evidence.caused_by_motion < criteria.larger_part;
}

Evidence withRestAsNoise(Evidence evidence, const Criteria& criteria) {
  double least = evidence.reEstimated().held_out;
  double least_unseen = evidence.has_unseen_logs ? evidence.reEstimated().unseen->gap : 0.0;
  for (const HypothesisEvidence& hypothesis : evidence.hypotheses) {
    if (isFunctionOfMotion(hypothesis)) {
      least = std::min(least, hypothesis.held_out);
      least_unseen = hypothesis.unseen ? std::min(least_unseen, hypothesis.unseen->gap) : least_unseen;
    }
  }
  evidence.noise_floor = floorOf(evidence.reEstimated().held_out, evidence.noise_floor, evidence.caused_by_motion,
                                 least, criteria.floor_margin);
  if (evidence.has_unseen_logs) {
    const UnseenErrors values = *evidence.reEstimated().unseen;
    const double floor =
        floorOf(values.gap, values.noise_floor, evidence.caused_by_motion, least_unseen, criteria.floor_margin);
    for (HypothesisEvidence& hypothesis : evidence.hypotheses) {
      hypothesis.unseen->noise_floor = std::max(hypothesis.unseen->noise_floor, floor);
    }
  }
  return evidence;
}

bool closesBeyondNoise(const Evidence& evidence, const Criteria& criteria, int hypothesis) {
  const Evidence all = withFurtherLogs(evidence);
  const Weighing weighing(all, criteria);
  const auto closes = [&](double before, double after, double floor) {
    return weighing.isBeyondNoise(gap::residualAboveFloor(before, after), floor);
  };
  const HypothesisEvidence& values = evidence.reEstimated();
  const HypothesisEvidence& effects = evidence.at(hypothesis);
  const bool here = closes(values.held_out, effects.held_out, evidence.noise_floor);
  const bool unseen =
      !evidence.has_unseen_logs || closes(values.unseen->gap, effects.unseen->gap, effects.unseen->noise_floor);
  return here && unseen && weighing.chanceOfGain(all.at(hypothesis), all.reEstimated()) < criteria.chance;
}

}  // namespace rubber_suspension::diagnosis
