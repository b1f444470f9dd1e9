// The proposal, in words and numbers.
#include "diagnosis/experiment/next_experiment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnosis/experiment/bounds.h"
#include "diagnosis/experiment/discrimination.h"
#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/menu.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kSure = 0.95;          // probability of a verdict that no further experiment is proposed for
constexpr double kWorthPlaying = 0.25;  // of what is open about the names, that a motion has to settle
constexpr double kNothingOpen = 1e-3;   // bit

std::vector<double> probabilitiesOf(const std::vector<Explanation>& explanations) {
  return element::each(explanations, [](const Explanation& explanation) { return explanation.probability; });
}

// A wider limit, and what it would be called.
struct Relaxation {
  std::string text;
  Bounds bounds;
};

std::vector<Relaxation> relaxationsOf(const Bounds& bounds) {
  constexpr double kWider = 2.0;
  constexpr double kLonger = 5.0;
  constexpr double kForce = 3.0;  // what more stroke or speed may need: stiffening included
  std::vector<Relaxation> result;
  Bounds wider = bounds;
  wider.stroke.half *= kWider;
  wider.speed *= kWider;
  wider.force *= kForce;
  result.push_back({fmt::format("a stroke of {}", words::quantity(wider.stroke.half, "m")), wider});
  Bounds faster = bounds;
  faster.speed *= kWider;
  faster.frequency *= kWider;
  faster.force *= kForce;
  result.push_back(
      {fmt::format("{:.3g} Hz and a speed of {}", faster.frequency, words::quantity(faster.speed, "m/s")), faster});
  Bounds longer = bounds;
  longer.duration *= kLonger;
  result.push_back({fmt::format("a log of {}", words::quantity(longer.duration, "s")), longer});
  return result;
}

class Proposer {
 public:
  Proposer(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits, int threads)
      : search_(workings.search),
        bounds_(boundsOf(search_.excitation, fitter.records(), limits)),
        explanations_(explanationsOf(workings)),
        open_(openNames(explanations_, probabilitiesOf(explanations_))),
        discriminator_(fitter, search_, explanations_, bounds_.force, threads) {}

  NextExperiment run() {
    if (explanations_.size() < 2) {
      return {"None: no second explanation was fitted.", {}};
    }
    if (open_ < kNothingOpen) {
      return {fmt::format("None: {} name the same effects.", allNames()), {}};
    }
    const std::vector<Experiment> menu = experimentMenu(bounds_);
    const Discrimination best = discriminator_.best(menu);
    if (best.experiment == nullptr) {
      return {"None: no motion of the menu stays within the limits of stroke, speed, force and duration.", {}};
    }
    return isWorthPlaying(best) ? proposal(best) : none(best);
  }

 private:
  bool isWorthPlaying(const Discrimination& one) const {
    return one.experiment != nullptr && open_ - one.open >= kWorthPlaying * open_;
  }

  std::string openText(const Discrimination& one) const { return fmt::format("{:.2g} of {:.2g} bit", one.open, open_); }

  std::string nameOfExplanation(std::size_t explanation) const {
    return nameOf(search_, *explanations_[explanation].fitted);
  }

  NextExperiment proposal(const Discrimination& best) const {
    const Experiment& chosen = *best.experiment;
    NextExperiment next;
    next.text = fmt::format(
        "{}. It is to decide between {}. {}Of what is open about the names, {} are expected to remain. The right one "
        "alone remains in {} % of cases.",
        chosen.description, allNames(), nearestText(best), openText(best), words::chance(best.probability));
    next.proposed.description = chosen.description;
    next.proposed.dt = chosen.dt;
    next.proposed.displacement.assign(chosen.displacement.begin(), chosen.displacement.end());
    next.proposed.decides = nameOfExplanation(0);
    for (std::size_t e = 1; e < explanations_.size(); ++e) {
      next.proposed.against.push_back(nameOfExplanation(e));
    }
    next.proposed.difference = best.difference;
    next.proposed.open_before = open_;
    next.proposed.open_after = best.open;
    next.proposed.probability = best.probability;
    return next;
  }

  std::string nearestText(const Discrimination& best) const {
    return best.nearest == 0
               ? ""
               : fmt::format("If {} is right, {}, fitted anew, would be off by {} there. ", nameOfExplanation(0),
                             nameOfExplanation(best.nearest), words::quantity(best.difference, "N"));
  }

  std::string allNames() const {
    std::vector<std::string> names;
    for (std::size_t e = 0; e < explanations_.size(); ++e) {
      names.push_back(nameOfExplanation(e));
    }
    return words::enumerated(names);
  }

  NextExperiment none(const Discrimination& best) {
    std::string text = fmt::format(
        "None within the limits: of what is open about the names of {}, {} would remain. The motion that tells most is "
        "this: {}. ",
        allNames(), openText(best), best.experiment->description);
    for (const Relaxation& relaxation : relaxationsOf(bounds_)) {
      const std::vector<Experiment> menu = experimentMenu(relaxation.bounds);
      discriminator_.setForceLimit(relaxation.bounds.force);
      const Discrimination wider = discriminator_.best(menu);
      if (isWorthPlaying(wider)) {
        return {text + fmt::format("It would take {}: {}, after which {} remain.", relaxation.text,
                                   wider.experiment->description, openText(wider)),
                {}};
      }
    }
    return {text + "Twice the stroke, twice the speed or five times the time would not do.", {}};
  }

  const hypotheses::Search& search_;
  Bounds bounds_;
  std::vector<Explanation> explanations_;
  double open_;  // of the names, before any motion [bit]
  Discriminator discriminator_;
};

}  // namespace

NextExperiment nextExperiment(const fit::Fitter& fitter, const Workings& workings, const ExperimentLimits& limits,
                              int threads) {
  if (workings.answer.verdict == Verdict::none) {
    return {"None is needed: the model agrees with the measurement as far as these logs can show.", {}};
  }
  if (workings.answer.probability > kSure && !leavesRest(workings.answer.verdict)) {
    return {fmt::format("None is needed: the verdict stands at {} %.", words::chance(workings.answer.probability)), {}};
  }
  return Proposer(fitter, workings, limits, threads).run();
}

}  // namespace rubber_suspension::diagnosis::experiment
