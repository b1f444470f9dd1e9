// Searches for the experiment that a report proposes.
#include "diagnosis/experiment/next_experiment.h"

#include <utility>

#include "diagnosis/experiment/discrimination.h"
#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/menu.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kSure = 0.95;          // probability of the verdict above which no experiment is proposed
constexpr double kWorthPlaying = 0.25;  // smallest fraction of the entropy that a proposed motion has to remove
constexpr double kNothingOpen = 1e-3;   // entropy below which all explanations name the same effects [bit]

struct Relaxation {
  WiderLimit limit;
  Bounds bounds;
};

std::vector<Relaxation> relaxationsOf(const Bounds& bounds) {
  constexpr double kWider = 2.0;
  constexpr double kLonger = 5.0;
  constexpr double kForce = 3.0;  // factor of the force at twice the stroke or speed, which allows for stiffening
  Bounds wider = bounds;
  wider.stroke.half *= kWider;
  wider.speed *= kWider;
  wider.force *= kForce;
  Bounds faster = bounds;
  faster.speed *= kWider;
  faster.frequency *= kWider;
  faster.force *= kForce;
  Bounds longer = bounds;
  longer.duration *= kLonger;
  return {{WiderLimit::stroke, wider}, {WiderLimit::speed, faster}, {WiderLimit::duration, longer}};
}

class Proposer {
 public:
  Proposer(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits, int threads)
      : bounds_(boundsOf(workings.search.excitation, fitter.records(), limits)),
        explanations_(explanationsOf(workings)),
        discriminator_(fitter, workings.search, explanations_, bounds_.force, threads) {
    next_.open = openNames(explanations_, probabilitiesOf(explanations_));
    next_.names = element::each(
        explanations_, [&](const Explanation& explanation) { return nameOf(workings.search, *explanation.fitted); });
  }

  NextExperiment run() {
    next_.proposal = propose();
    return std::move(next_);
  }

 private:
  Proposal propose() {
    if (explanations_.size() < 2) {
      return Proposal::no_rival;
    }
    if (next_.open < kNothingOpen) {
      return Proposal::same_effects;
    }
    const std::vector<Experiment> menu = experimentMenu(bounds_);
    const Discrimination best = discriminator_.best(menu);
    if (best.experiment == nullptr) {
      return Proposal::no_motion;
    }
    next_.motion = best.experiment->description;
    next_.open_after = best.open;
    next_.nearest = best.nearest == 0 ? "" : next_.names[best.nearest];
    if (!isWorthPlaying(best)) {
      return widen();
    }
    addProposed(best);
    return Proposal::within_limits;
  }

  bool isWorthPlaying(const Discrimination& one) const {
    return one.experiment != nullptr && next_.open - one.open >= kWorthPlaying * next_.open;
  }

  void addProposed(const Discrimination& best) {
    const Experiment& chosen = *best.experiment;
    next_.proposed.description = chosen.description;
    next_.proposed.dt = chosen.dt;
    next_.proposed.displacement.assign(chosen.displacement.begin(), chosen.displacement.end());
    next_.proposed.decides = next_.names.front();
    next_.proposed.against.assign(next_.names.begin() + 1, next_.names.end());
    next_.proposed.difference = best.difference;
    next_.proposed.open_before = next_.open;
    next_.proposed.open_after = best.open;
    next_.proposed.probability = best.probability;
  }

  Proposal widen() {
    for (const Relaxation& relaxation : relaxationsOf(bounds_)) {
      const std::vector<Experiment> menu = experimentMenu(relaxation.bounds);
      discriminator_.setForceLimit(relaxation.bounds.force);
      const Discrimination wider = discriminator_.best(menu);
      if (isWorthPlaying(wider)) {
        next_.limit = relaxation.limit;
        next_.wider = relaxation.bounds;
        next_.wider_motion = wider.experiment->description;
        next_.wider_open_after = wider.open;
        return Proposal::beyond_limits;
      }
    }
    return Proposal::none;
  }

  Bounds bounds_;
  std::vector<Explanation> explanations_;
  Discriminator discriminator_;
  NextExperiment next_;
};

}  // namespace

NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads) {
  NextExperiment none;
  if (workings.answer.verdict == Verdict::none) {
    none.proposal = Proposal::agrees;
    return none;
  }
  if (workings.answer.probability > kSure && !leavesRest(workings.answer.verdict)) {
    none.proposal = Proposal::sure;
    return none;
  }
  return Proposer(fitter, workings, limits, threads).run();
}

}  // namespace rubber_suspension::diagnosis::experiment
