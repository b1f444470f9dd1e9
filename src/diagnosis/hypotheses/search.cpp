// Searches for the sets of effects that explain a measurement.
#include "diagnosis/hypotheses/search.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "diagnosis/hypotheses/measured.h"
#include "diagnosis/hypotheses/odds.h"
#include "diagnosis/hypotheses/screening.h"
#include "diagnosis/hypotheses/shapes.h"
#include "diagnosis/hypotheses/starts.h"
#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "fit/parallel.h"
#include "io/effect_names.h"
#include "log/text.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

constexpr int kBaseIterations = 40;
constexpr std::size_t kMostOfOneSize = 8;  // largest number of pairs, and of triples, that are fitted in one stage
constexpr std::size_t kMostStarts = 3;     // largest number of hypotheses to which further effects are added
constexpr std::size_t kAtOnce = 4;  // number of sets that are fitted before the remaining ones are compared again
constexpr std::size_t kMostEffects = 3;
// A set is neither fitted nor extended if its log odds are lower than those of the best set by more than kWithinReach.
// The limit is larger by kScreeningKnown for screened odds, because screening linearises the laws.
constexpr double kWithinReach = 4.6;
constexpr double kScreeningKnown = 2.3;
constexpr double kWorthAFit = 2.3;  // larger sets are fitted if they could be a tenth as likely as the best (log odds)
// A fit is abandoned if the error that it promises exceeds the least screened error of its size by this factor.
constexpr double kHopeless = 2.0;

// A set of effects that may be worth a fit, and the parameters from which this fit starts.
struct Planned {
  fit::Hypothesis hypothesis;
  double error = 0.0;  // screened error
  double odds = 0.0;
  fit::ParameterVector start;
};

// Sets that may be worth a fit, sorted by their odds. The odds are computed as if no error were below `floor`.
struct Plan {
  std::vector<Planned> sets;
  double floor;
};

bool isAmong(const std::vector<std::string>& effects, const std::string& effect) {
  return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

Odds oddsAt(const Search& search, double floor) {
  return {search.candidates, floor, search.re_estimated.fit.score(), search.re_estimated.fit.blocks.size(),
          search.noise.of_logs.size()};
}

// A fitted hypothesis of a list, and its fit with another law.
struct OtherLaw {
  FittedHypothesis* as_is;
  int member = 0;  // effect whose law follows a curve in the other fit
  std::optional<FittedHypothesis> fitted = {};
};

class Searcher {
 public:
  // Adds fits to `result`. Excluded effects do not compete with others.
  Searcher(const Measured& measured, const std::vector<std::string>& excluded, int threads,
           const ProgressCallback& progress, Search& result)
      : measured_(measured),
        fitter_(measured.fitter()),
        excluded_(excluded),
        threads_(threads),
        progress_(progress),
        result_(result) {}

  void run() {
    result_.guess = fitter_.model().isGuess();
    result_.excluded = excluded_;
    tell("re-estimating the model parameters", 0.0);
    reEstimate();
    result_.candidates = measured_.candidates(result_.excitation, result_.re_estimated, threads_);
    tell("screening single effects", 0.2);
    const Screening screening(fitter_, result_.candidates, result_.re_estimated, threads_);
    tell("fitting single effects", 0.3);
    fitSingles(screening);
    tryOtherLaws(result_.singles);
    measureVisibility(screening);
    tell("fitting pairs", 0.5);
    if (fitSets(screening, 2, result_.pairs)) {
      tell("fitting triples", 0.75);
      fitSets(screening, kMostEffects, result_.triples);
    }
    fitPartsOfTriples();
    if (!excluded_.empty()) {
      Searcher(measured_, {}, threads_, progress_, result_).fitOtherwise(screening);
    }
    endFits();
    settle(result_.singles);
    settle(result_.pairs);
    settle(result_.triples);
    countNumbers();
  }

 private:
  void tell(const std::string& stage, double fraction) const {
    if (progress_) {
      progress_(stage, fraction);
    }
  }

  void reEstimate() {
    const fit::Hypothesis model;
    const std::array<std::function<void()>, 2> tasks = {
        [&] {
          const fit::ParameterVector configured = fitter_.configured(model);
          result_.configured_gap = fitter_.gapAt(model, configured);
          result_.re_estimated.fit = fitter_.fitAlone({kBaseIterations});
          result_.as_configured = result_.re_estimated;
          result_.as_configured.fit.parameters = configured;
          result_.discretisation = measured_.discretisationError(result_.re_estimated);
        },
        [&] { result_.excitation = measured_.excitation(); }};
    fit::parallelFor(tasks.size(), threads_, [&](std::size_t i) { tasks[i](); });
  }

  // Fits the most promising effects first, because their errors show for which other effects a fit is hopeless.
  void fitSingles(const Screening& screening) {
    std::vector<Screened> order;
    for (int c = 0; c < static_cast<int>(result_.candidates.size()); ++c) {
      result_.singles.push_back({screening.hypothesisOf({c}), {}});
      order.push_back(screening.screen({c}));
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const Screened& x, const Screened& y) { return x.error < y.error; });
    const auto others = order.begin() + static_cast<std::ptrdiff_t>(std::min(kAtOnce, order.size()));
    fitSingles(screening, {order.begin(), others});
    // Laws that have to be simulated take longest. They are fitted first, so that no thread waits for them at the end.
    std::stable_partition(others, order.end(),
                          [&](const Screened& screened) { return !singleOf(screened).hypothesis.isAdditive(); });
    fitSingles(screening, {others, order.end()});
    settle(result_.singles);
    countNumbers();
    estimateNoise();
  }

  // Counts the numbers of laws alone, to which those of a law that contains them are compared.
  void countNumbers() const {
    for (const FittedHypothesis& single : result_.singles) {
      result_.candidates[static_cast<std::size_t>(single.hypothesis.members.front())].numbers_alone =
          static_cast<std::size_t>((single.fit.parameters.scales.array() != 0.0).count());
    }
  }

  void fitSingles(const Screening& screening, const std::vector<Screened>& some) {
    double least = bestOfAll()->fit.gap;
    for (const Screened& screened : some) {
      if (competes(singleOf(screened))) {
        least = std::min(least, screened.error);
      }
    }
    const double reach = kHopeless * std::max(least, result_.discretisation);
    fit::parallelFor(some.size(), threads_, [&](std::size_t i) {
      FittedHypothesis& single = singleOf(some[i]);
      if (single.hypothesis.like_parameters) {
        fitGains(fitter_, result_.re_estimated, reach, single);
      } else {
        fitSingle(fitter_, result_.re_estimated, screening.bestOf(some[i].members), reach, single);
      }
    });
  }

  FittedHypothesis& singleOf(const Screened& screened) {
    return result_.singles[static_cast<std::size_t>(screened.members.front())];
  }

  void estimateNoise() { result_.noise = measured_.estimateNoise(*bestOfAll(), result_); }

  // Computes the visibility of the candidates, the residuals if they are added, and the gap of a flexible fit.
  void measureVisibility(const Screening& screening) {
    result_.visibility = screening.visibility(result_.noise.floor);
    result_.implants = implantAll(fitter_, screening, threads_);
    std::vector<int> all;
    for (const FittedHypothesis& single : result_.singles) {
      if (competes(single)) {
        all.push_back(single.hypothesis.members.front());
      }
    }
    result_.surrogate_gap = screening.screen(all).error;
  }

  // A law fits at least as well as one that it contains, and a set at least as well as its parts. If the fit of a part
  // has the smaller error, the fit of the whole is repeated from the parameters of that part.
  void settle(std::vector<FittedHypothesis>& list) const {
    constexpr double kAsGood = 1.005;
    std::vector<std::optional<FittedHypothesis>> again(list.size());
    fit::parallelFor(list.size(), threads_, [&](std::size_t i) {
      const FittedHypothesis* held = leastHeldBy(list[i].hypothesis.members);
      if (held != nullptr && kAsGood * held->fit.gap < list[i].fit.gap) {
        std::vector<int> preferred = held->hypothesis.members;
        preferred.insert(preferred.end(), held->hypothesis.held.begin(), held->hypothesis.held.end());
        again[i] = {
            fit::makeHypothesis(result_.candidates, list[i].hypothesis.members, preferred, held->hypothesis.curved),
            {}};
        fitBeyond(fitter_, *held, *again[i]);
      }
    });
    bool better = false;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (again[i] && again[i]->fit.gap < list[i].fit.gap) {
        list[i] = std::move(*again[i]);
        better = true;
      }
    }
    if (better) {  // sets that contain the improved ones may improve as well
      settle(list);
    }
  }

  // Continues fits whose gap exceeds their held-out gap by more than chance, because they ended too early.
  void endFits() {
    std::vector<FittedHypothesis*> begun = {&result_.re_estimated};
    for (std::vector<FittedHypothesis>* list : {&result_.singles, &result_.pairs, &result_.triples}) {
      for (FittedHypothesis& fitted : *list) {
        begun.push_back(&fitted);
      }
    }
    begun.erase(
        std::remove_if(begun.begin(), begun.end(),
                       [](const auto* fitted) { return fitted->fit.gap <= kBetterByChance * fitted->fit.held_out; }),
        begun.end());
    fit::parallelFor(begun.size(), threads_, [&](std::size_t i) {
      fit::FitLimits limits{kBaseIterations};
      limits.about_its_end = true;
      begun[i]->fit = fitter_.fit(begun[i]->hypothesis, begun[i]->fit.parameters, limits);
    });
  }

  void tryOtherLaws(std::vector<FittedHypothesis>& list) {
    tryCurve(list);
    tryFactors(list);
  }

  // Fits each effect's law along a curve, and keeps a fit if it is likelier than the one without a curve.
  void tryCurve(std::vector<FittedHypothesis>& list) {
    std::vector<OtherLaw> straight;
    for (FittedHypothesis& fitted : list) {
      for (const int member : fitted.hypothesis.members) {
        if (mayFollowCurve(fitted, member)) {
          straight.push_back({&fitted, member});
        }
      }
    }
    std::stable_sort(straight.begin(), straight.end(),
                     [&](const auto& x, const auto& y) { return oddsOf(*x.as_is) > oddsOf(*y.as_is); });
    if (straight.empty() || !findCurve(*straight.front().as_is, straight.front().member)) {
      return;
    }
    const double reach = kHopeless * bestOfAll()->fit.gap;
    fit::parallelFor(straight.size(), threads_, [&](std::size_t i) {
      OtherLaw& law = straight[i];
      law.fitted = {alongCurve(law.as_is->hypothesis, law.member), {}};
      fitCurved(fitter_, *law.as_is, reach, *law.fitted);
    });
    takeLikelier(straight, list);
  }

  // Fits friction with a factor for each log, and keeps a fit if it is likelier than the one without factors.
  void tryFactors(std::vector<FittedHypothesis>& list) {
    std::vector<OtherLaw> with;
    for (FittedHypothesis& fitted : list) {
      if (mayHaveFactors(fitted)) {
        with.push_back({&fitted});
      }
    }
    const double reach = kHopeless * bestOfAll()->fit.gap;
    fit::parallelFor(with.size(), threads_, [&](std::size_t i) {
      FittedHypothesis fitted = withFactors(fitter_, *with[i].as_is, reach);
      if (fitted.hypothesis.free_in_log.by_factor) {
        with[i].fitted = std::move(fitted);
      }
    });
    takeLikelier(with, list);
  }

  void takeLikelier(std::vector<OtherLaw>& others, std::vector<FittedHypothesis>& list) {
    bool better = false;
    for (OtherLaw& other : others) {
      if (other.fitted && oddsOf(*other.fitted) > oddsOf(*other.as_is)) {
        *other.as_is = std::move(*other.fitted);
        better = true;
      }
    }
    if (better) {
      settle(list);
      estimateNoise();
    }
  }

  // Returns true if factors on friction could improve the odds by more than their cost.
  bool mayHaveFactors(const FittedHypothesis& fitted) const {
    const std::vector<int>& members = fitted.hypothesis.members;
    const bool friction = std::any_of(members.begin(), members.end(), [&](int member) {
      return result_.candidates[static_cast<std::size_t>(member)].is_friction;
    });
    fit::Hypothesis with = fitted.hypothesis;
    with.free_in_log.by_factor = fit::columnOf({});
    return friction && competes(fitted) && !fitted.hypothesis.free_in_log.by_factor &&
           !fitted.hypothesis.free_in_log.gain &&
           odds().of(with, fitted.fit.parameters.scales, result_.noise.floor) > oddsOf(fitted);
  }

  // Returns true if a law along a curve could improve the odds by more than its cost.
  bool mayFollowCurve(const FittedHypothesis& fitted, int member) const {
    const std::vector<int>& curved = fitted.hypothesis.curved;
    const fit::Candidate& candidate = result_.candidates[static_cast<std::size_t>(member)];
    return candidate.along && candidate.applies() && std::find(curved.begin(), curved.end(), member) == curved.end() &&
           competes(fitted) && fitted.fit.gap <= kHopeless * bestOfAll()->fit.gap &&
           oddsWithCurve(fitted, result_.noise.floor) > oddsOf(fitted);
  }

  // Returns the log odds of the same effects with one more parameter and the error `left`.
  double oddsWithCurve(const FittedHypothesis& fitted, double left) const {
    fit::Hypothesis with = fitted.hypothesis;
    with.curved.push_back(0);
    return odds().of(with, fitted.fit.parameters.scales, left);
  }

  fit::Hypothesis alongCurve(const fit::Hypothesis& hypothesis, int member) const {
    std::vector<int> curved = hypothesis.curved;
    curved.push_back(member);
    return fit::makeHypothesis(result_.candidates, hypothesis.members, hypothesis.held, curved);
  }

  // Finds one curve for all laws that may follow one. Returns false if its cost exceeds its gain for this hypothesis.
  bool findCurve(const FittedHypothesis& about, int member) {
    if (hasCurve()) {
      return true;
    }
    const CurveLook best = bestCurve(fitter_, about, result_.candidates[static_cast<std::size_t>(member)], member,
                                     measured_.records(), threads_);
    if (!(oddsWithCurve(about, best.left) >
          odds().of(about.hypothesis, about.fit.parameters.scales, best.left_straight))) {
      return false;
    }
    std::vector<fit::Candidate> curved;
    for (const fit::Candidate& candidate : result_.candidates) {
      curved.emplace_back();
      if (candidate.along) {
        curved.back().terms = candidate.along(best.curve);
      }
    }
    fit::findUnitEffects(curved, measured_.records(), threads_);
    for (std::size_t c = 0; c < curved.size(); ++c) {
      result_.candidates[c].curved = std::move(curved[c].terms);
    }
    return true;
  }

  bool hasCurve() const {
    return std::any_of(result_.candidates.begin(), result_.candidates.end(),
                       [](const fit::Candidate& candidate) { return !candidate.curved.empty(); });
  }

  // Returns the fit with the least error among the sets that this set contains, or null if none was fitted.
  const FittedHypothesis* leastHeldBy(const std::vector<int>& members) const {
    const FittedHypothesis* least = nullptr;
    for (const FittedHypothesis* fitted : result_.withEffects()) {
      const std::vector<int>& part = fitted->hypothesis.members;
      const bool held = part != members && competes(*fitted) && fit::holds(result_.candidates, members, part);
      least = held && (least == nullptr || fitted->fit.gap < least->fit.gap) ? fitted : least;
    }
    return least;
  }

  // Odds for the noise floor without the errors of the rig.
  Odds odds() const { return oddsAt(result_, result_.noise.floor); }
  double oddsOf(const FittedHypothesis& fitted) const { return oddsOf(fitted, result_.noise.floor); }

  // Returns the log odds of a fit, computed as if no error were below `floor`.
  double oddsOf(const FittedHypothesis& fitted, double floor) const {
    return oddsAt(result_, floor).of(fitted.hypothesis, fitted.fit.parameters.scales, fitted.fit.score());
  }

  const FittedHypothesis* bestOfAll() const {
    const FittedHypothesis* best = &result_.re_estimated;
    for (const FittedHypothesis* fitted : result_.withEffects()) {
      best = competes(*fitted) && fitted->fit.score() < best->fit.score() ? fitted : best;
    }
    return best;
  }

  double bestOdds(double floor) const {
    double best = -std::numeric_limits<double>::infinity();
    for (const FittedHypothesis* fitted : result_.withEffects()) {
      best = competes(*fitted) ? std::max(best, oddsOf(*fitted, floor)) : best;
    }
    return best;
  }

  // Returns true if a set of this number of effects could be nearly as likely as the best hypothesis so far.
  bool isWorthMore(std::size_t effects, double floor) const {
    return oddsAt(result_, floor).mostOf(effects) > bestOdds(floor) - kWorthAFit;
  }

  // Returns the likeliest hypotheses with this number of effects, to which further effects are added. They are those
  // within kWithinReach and one more, because an effect that is unlikely alone may be one of a likely pair.
  std::vector<const FittedHypothesis*> likeliest(std::size_t effects, double floor) const {
    std::vector<const FittedHypothesis*> chosen;
    for (const FittedHypothesis* fitted : result_.withEffects()) {
      if (fitted->hypothesis.members.size() == effects && competes(*fitted)) {
        chosen.push_back(fitted);
      }
    }
    const auto odds = [&](const FittedHypothesis* fitted) { return oddsOf(*fitted, floor); };
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](const FittedHypothesis* x, const FittedHypothesis* y) { return odds(x) > odds(y); });
    std::size_t count = 0;
    while (count < std::min(kMostStarts, chosen.size()) && odds(chosen[count]) > odds(chosen.front()) - kWithinReach) {
      ++count;
    }
    chosen.resize(std::min({count + 1, kMostStarts, chosen.size()}));
    return chosen;
  }

  // Plans the fits of sets with this number of effects. Pairs are screened about the model, and larger sets about the
  // fits of sets with one effect less. Sets that are not worth a fit or have been fitted are omitted. The floor is at
  // most the least screened error, because an effect may explain what the best fit attributes to the rig.
  Plan planFits(const Screening& about_model, std::size_t effects) const {
    Plan plan{{}, result_.noise.floor};
    if (!isWorthMore(effects, plan.floor)) {
      return plan;
    }
    plan.floor = result_.noise.floor_with_rig;
    std::map<std::vector<int>, Planned> best;  // planned fit of each set
    const auto add = [&](const Screening& screening, const std::vector<Screened>& sets) {
      for (const Screened& set : sets) {
        Planned& planned = best.try_emplace(set.members).first->second;
        if (planned.hypothesis.members.empty() || set.error < planned.error) {
          planned = planOf(screening, set);
        }
        plan.floor = std::max(std::min(plan.floor, set.error), result_.noise.floor);
      }
    };
    if (effects == 2) {
      add(about_model, about_model.pairs(competing()));
    }
    for (const FittedHypothesis* fitted : likeliest(effects - 1, plan.floor)) {
      add(about_model, about_model.withContained(competing(), fitted->hypothesis.members, effects));
      const Screening screening(fitter_, result_.candidates, *fitted, threads_);
      add(screening, screening.additions(competing(), fitted->hypothesis.members));
    }
    if (!isWorthMore(effects, plan.floor)) {
      return plan;
    }
    const Odds odds = oddsAt(result_, plan.floor);
    for (auto& [members, planned] : best) {
      if (!isFitted(members)) {
        planned.odds = odds.of(planned.hypothesis, planned.start.scales, planned.error);
        plan.sets.push_back(std::move(planned));
      }
    }
    std::stable_sort(plan.sets.begin(), plan.sets.end(),
                     [](const Planned& x, const Planned& y) { return x.odds > y.odds; });
    return plan;
  }

  // Fits the planned sets that could be as likely as the best, several at a time. Returns false if there are none.
  bool fitSets(const Screening& about_model, std::size_t effects, std::vector<FittedHypothesis>& list) {
    const auto [planned, floor] = planFits(about_model, effects);
    const std::size_t most = std::min(kMostOfOneSize, planned.size());
    std::size_t fitted = 0;
    while (fitted < most && planned[fitted].odds > bestOdds(floor) - kWithinReach - kScreeningKnown) {
      const double least_odds = bestOdds(floor) - kWithinReach - kScreeningKnown;
      std::vector<Planned> some;
      while (fitted < most && some.size() < kAtOnce && planned[fitted].odds > least_odds) {
        some.push_back(planned[fitted++]);
      }
      fitAll(some, list);
    }
    if (fitted > 0) {
      fitContained(about_model, effects, floor, list);
      estimateNoise();
      tryOtherLaws(list);
    }
    return fitted > 0;
  }

  // Fits likely sets in which a law is replaced by laws that it contains. Screening by error overlooks these sets,
  // because the larger law has the smaller error.
  void fitContained(const Screening& about_model, std::size_t effects, double floor,
                    std::vector<FittedHypothesis>& list) {
    std::map<std::vector<int>, Planned> contained;
    for (const FittedHypothesis* fitted : likeliest(effects, floor)) {
      for (const Screened& set : about_model.withContained(competing(), fitted->hypothesis.members, effects)) {
        if (!isFitted(set.members)) {
          contained[set.members] = planOf(about_model, set);
        }
      }
    }
    fitAll(element::each(contained, &std::pair<const std::vector<int>, Planned>::second), list);
  }

  bool isFitted(const std::vector<int>& members) const {
    const std::vector<const FittedHypothesis*> all = result_.withEffects();
    return std::any_of(all.begin(), all.end(),
                       [&](const FittedHypothesis* fitted) { return fitted->hypothesis.members == members; });
  }

  static Planned planOf(const Screening& screening, const Screened& set) {
    return {screening.hypothesisOf(set.members), set.error, 0.0, screening.bestOf(set.members)};
  }

  void fitAll(const std::vector<Planned>& planned, std::vector<FittedHypothesis>& list) {
    const std::size_t first = list.size();
    double least = std::numeric_limits<double>::infinity();
    for (const Planned& set : planned) {
      list.push_back({set.hypothesis, {}});
      least = std::min(least, set.error);
    }
    const auto from = element::each(planned, [&](const Planned& set) { return &bestFitted(set.hypothesis.members); });
    fit::parallelFor(planned.size(), threads_, [&](std::size_t i) {
      fitFurther(fitter_, *from[i], planned[i].start, kHopeless * least, list[first + i]);
    });
    settle(list);
    std::stable_sort(list.begin(), list.end(), [](const FittedHypothesis& x, const FittedHypothesis& y) {
      return x.fit.score() < y.fit.score();
    });
  }

  // Returns the best fit of a part of a set: a single effect, a pair within a triple, or a set with contained laws.
  const FittedHypothesis& bestFitted(const std::vector<int>& members) const {
    const FittedHypothesis* best = &result_.singles[static_cast<std::size_t>(members.front())];
    for (const FittedHypothesis* fitted : result_.withEffects()) {
      const std::vector<int>& part = fitted->hypothesis.members;
      const bool within = part != members && fit::holds(result_.candidates, members, part);
      best = within && fitted->fit.score() < best->fit.score() ? fitted : best;
    }
    return *best;
  }

  // Fits the pairs within the best triple, which show how much each of its three effects contributes.
  void fitPartsOfTriples() {
    if (result_.triples.empty()) {
      return;
    }
    std::vector<Planned> parts;
    const fit::Hypothesis triple = result_.triples.front().hypothesis;
    const std::vector<int>& members = triple.members;
    for (std::size_t i = 0; i < members.size(); ++i) {
      std::vector<int> part = members;
      part.erase(part.begin() + static_cast<std::ptrdiff_t>(i));
      if (!isFitted(part)) {
        const fit::Hypothesis hypothesis = fit::makeHypothesis(result_.candidates, part, triple.held, triple.curved);
        parts.push_back({hypothesis, std::numeric_limits<double>::infinity(), 0.0, fitter_.configured(hypothesis)});
      }
    }
    fitAll(parts, result_.pairs);
  }

  // Continues the search as if no effect were excluded. This gives excluded effects the probability that they would
  // have otherwise, and an estimate of the noise that does not depend on the exclusion.
  void fitOtherwise(const Screening& screening) {
    estimateNoise();
    tryOtherLaws(result_.singles);
    fitSets(screening, 2, result_.pairs);
    fitSets(screening, kMostEffects, result_.triples);
    fitPartsOfTriples();
  }

  bool competes(const FittedHypothesis& fitted) const { return result_.competes(fitted.hypothesis, excluded_); }

  std::vector<int> competing() const {
    std::vector<int> competing;
    for (int c = 0; c < static_cast<int>(result_.candidates.size()); ++c) {
      const fit::Candidate& candidate = result_.candidates[static_cast<std::size_t>(c)];
      if (candidate.competes() && !isAmong(excluded_, candidate.effect)) {
        competing.push_back(c);
      }
    }
    return competing;
  }

  const Measured& measured_;
  const fit::HypothesisFitter& fitter_;
  std::vector<std::string> excluded_;
  int threads_;
  const ProgressCallback& progress_;
  Search& result_;
};

judge::HypothesisEvidence evidenceOf(const std::vector<fit::Candidate>& candidates, const FittedHypothesis& fitted) {
  judge::HypothesisEvidence evidence;
  evidence.members = fitted.hypothesis.members;
  evidence.terms = fitted.hypothesis.terms.size();
  evidence.beyond = fit::numbersBeyond(candidates, fitted.hypothesis, fitted.fit.parameters.scales);
  evidence.free_in_log = fitted.hypothesis.free_in_log;
  evidence.keeps_values = fitted.hypothesis.keepsParameters();
  const bool applies = !fitted.hypothesis.terms.empty() || fitted.hypothesis.members.empty();
  evidence.chi_squared =
      applies ? fitted.fit.chi_squared : std::numeric_limits<double>::infinity();  // infinite if no term was fitted
  return evidence;
}

}  // namespace

const FittedHypothesis& Search::at(int hypothesis) const {
  if (hypothesis < judge::Evidence::kFirstSingle) {
    return hypothesis == judge::Evidence::kAsConfigured ? as_configured : re_estimated;
  }
  std::size_t place = static_cast<std::size_t>(hypothesis - judge::Evidence::kFirstSingle);
  for (const auto* list : {&singles, &pairs}) {
    if (place < list->size()) {
      return (*list)[place];
    }
    place -= list->size();
  }
  return triples.at(place);
}

std::vector<const FittedHypothesis*> Search::withEffects() const {
  std::vector<const FittedHypothesis*> all;
  for (const auto* list : {&singles, &pairs, &triples}) {
    std::transform(list->begin(), list->end(), std::back_inserter(all),
                   [](const FittedHypothesis& fitted) { return &fitted; });
  }
  return all;
}

bool Search::competes(const fit::Hypothesis& hypothesis, const std::vector<std::string>& without) const {
  return hypothesis.competes() && std::none_of(hypothesis.members.begin(), hypothesis.members.end(), [&](int member) {
           return isAmong(without, candidates[static_cast<std::size_t>(member)].effect);
         });
}

const FittedHypothesis& Search::likeliestBeside(const FittedHypothesis& one) const {
  const Odds odds = oddsAt(*this, noise.floor_with_rig);
  const auto oddsOf = [&](const FittedHypothesis& fitted) {
    return odds.of(fitted.hypothesis, fitted.fit.parameters.scales, fitted.fit.score());
  };
  const FittedHypothesis* best = &re_estimated;
  for (const FittedHypothesis* fitted : withEffects()) {
    const bool likelier = best == &one || oddsOf(*fitted) > oddsOf(*best);
    best = fitted != &one && competes(fitted->hypothesis, excluded) && likelier ? fitted : best;
  }
  return *best;
}

judge::Evidence evidenceOfNone(const Search& search) {
  judge::Evidence evidence;
  evidence.guess = search.guess;
  for (const fit::Candidate& candidate : search.candidates) {
    evidence.effects.push_back(candidate.effect);
    evidence.one_form.push_back(candidate.one_form);
    evidence.constant.push_back(candidate.constant);
    evidence.contains.push_back(fit::containedBy(search.candidates, candidate));
  }
  return evidence;
}

judge::Evidence evidenceOf(const Search& search) {
  judge::Evidence evidence = evidenceOfNone(search);
  evidence.hypotheses = {{}, evidenceOf(search.candidates, search.re_estimated)};
  for (const FittedHypothesis* fitted : search.withEffects()) {
    evidence.hypotheses.push_back(evidenceOf(search.candidates, *fitted));
  }
  for (const std::string& effect : evidence.effects) {
    evidence.excluded.push_back(isAmong(search.excluded, effect));
  }
  return evidence;
}

std::vector<std::string> excludedEffects(const io::ComponentDescription& component, const DiagnosisOptions& options) {
  std::vector<std::string> excluded = component.excluded_effects;
  const std::vector<std::string>& names = io::effectNames();
  for (const std::string& effect : options.excluded) {
    element::refuseIf(!isAmong(names, effect), "excluded: '{}' is not an effect{}; accepted: {}", effect,
                      element::didYouMean(effect, names), log::join(names));
    excluded.push_back(effect);
  }
  return excluded;
}

Search search(const Measured& measured, const std::vector<std::string>& excluded, int threads,
              const ProgressCallback& progress) {
  Search result;
  Searcher(measured, excluded, threads, progress, result).run();
  return result;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
