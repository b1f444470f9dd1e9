// The proposal, in words and numbers.
#include "diagnosis/experiment/next_experiment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnosis/experiment/bounds.h"
#include "diagnosis/experiment/discrimination.h"
#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/menu.h"
#include "diagnosis/words/text.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kSure = 0.95;  // probability of a verdict that no further experiment is proposed for

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
        discriminator_(fitter, search_, explanations_, bounds_.force, threads) {}

  NextExperiment run() {
    if (explanations_.size() < 2) {
      return {"None: no second explanation was fitted.", {}};
    }
    const std::vector<Experiment> menu = experimentMenu(bounds_);
    const Discrimination best = discriminator_.best(menu);
    if (best.experiment == nullptr) {
      return {"None: no motion of the menu stays within the limits of stroke, speed, force and duration.", {}};
    }
    return best.floors < kLeastFloors ? none(best) : proposal(best);
  }

 private:
  std::string nameOfExplanation(std::size_t explanation) const {
    return nameOf(search_, *explanations_[explanation].fitted);
  }

  NextExperiment proposal(const Discrimination& best) const {
    const Experiment& chosen = *best.experiment;
    NextExperiment next;
    next.text = fmt::format(
        "{}. It is to decide between {}. If {} is right, {}, fitted anew, would be off by {} there. Whichever is "
        "right, "
        "the nearest other one is off by {:.1f} times the noise on average. The right one alone remains in {} % of "
        "cases.",
        chosen.description, allNames(), nameOfExplanation(0), nameOfExplanation(best.nearest),
        words::quantity(best.difference, "N"), best.floors, words::chance(best.probability));
    next.proposed.description = chosen.description;
    next.proposed.dt = chosen.dt;
    next.proposed.displacement.assign(chosen.displacement.begin(), chosen.displacement.end());
    next.proposed.decides = nameOfExplanation(0);
    for (std::size_t e = 1; e < explanations_.size(); ++e) {
      next.proposed.against.push_back(nameOfExplanation(e));
    }
    next.proposed.difference = best.difference;
    next.proposed.floors = best.floors;
    next.proposed.probability = best.probability;
    return next;
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
        "None within the limits: {}, fitted anew, would differ by {:.1f} times the noise, and {:.0f} times are needed. "
        "The motion that tells most is this: {}. ",
        allNames(), best.floors, kLeastFloors, best.experiment->description);
    for (const Relaxation& relaxation : relaxationsOf(bounds_)) {
      const std::vector<Experiment> menu = experimentMenu(relaxation.bounds);
      discriminator_.setForceLimit(relaxation.bounds.force);
      const Discrimination wider = discriminator_.best(menu, kLeastFloors);
      if (wider.experiment != nullptr && wider.floors >= kLeastFloors) {
        return {text + fmt::format("It would take {}: {}, {:.1f} times the noise.", relaxation.text,
                                   wider.experiment->description, wider.floors),
                {}};
      }
    }
    return {text + fmt::format(
                       "Twice the stroke, twice the speed or five times the time would not do. The noise would have "
                       "to fall to {:.2g} % of today's.",
                       100.0 * best.floors / kLeastFloors),
            {}};
  }

  const hypotheses::Search& search_;
  Bounds bounds_;
  std::vector<Explanation> explanations_;
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
