// The search over candidate effects.
#include "diagnosis/hypotheses/search.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "diagnosis/hypotheses/screening.h"
#include "diagnosis/hypotheses/search_evidence.h"
#include "diagnosis/hypotheses/sets.h"
#include "diagnosis/hypotheses/starts.h"
#include "diagnosis/judge/judge.h"
#include "diagnosis/judge/weighing.h"
#include "diagnosis/prepare/measured.h"
#include "fit/parallel.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kBaseIterations = 14;
constexpr std::size_t kPairsFitted = 6;
constexpr std::size_t kAdditionsFitted = 2;
constexpr std::size_t kLastResortsFitted = 1;  // beside the best single effect
constexpr double kSignificantRest = 1.5;  // held-out error over the noise floor that makes triples worth their time

// The best fit of a part of a set: of one of its members, or of the pairs of a triple.
const FittedHypothesis& bestPart(const Search& result, const std::vector<int>& members) {
  const FittedHypothesis* best = &result.singles[static_cast<std::size_t>(members.front())];
  for (const FittedHypothesis* fitted : result.withEffects()) {
    const std::vector<int>& part = fitted->hypothesis.members;
    const bool within =
        part.size() < members.size() && std::includes(members.begin(), members.end(), part.begin(), part.end());
    best = within && fitted->fit.score() < best->fit.score() ? fitted : best;
  }
  return *best;
}

// Take the best of a screening that are not yet in the list.
void choose(const std::vector<fit::Candidate>& candidates, const std::vector<Screened>& screened, std::size_t most,
            std::vector<FittedHypothesis>& list) {
  for (std::size_t i = 0; i < std::min(most, screened.size()); ++i) {
    const auto same = [&](const FittedHypothesis& other) { return other.hypothesis.members == screened[i].members; };
    if (std::none_of(list.begin(), list.end(), same)) {
      list.push_back({fit::makeHypothesis(candidates, screened[i].members), {}});
    }
  }
}

void sortByScore(std::vector<FittedHypothesis>& list) {
  std::sort(list.begin(), list.end(),
            [](const FittedHypothesis& x, const FittedHypothesis& y) { return x.fit.score() < y.fit.score(); });
}

class Searcher {
 public:
  Searcher(const Measured& measured, const Criteria& criteria, int threads, const ProgressCallback& progress)
      : measured_(measured), fitter_(measured.fitter()), criteria_(criteria), threads_(threads), progress_(progress) {}

  Search run() {
    say("re-estimating the model parameters", 0.0);
    reEstimate();
    say("fitting single effects", 0.1);
    result_.candidates = measured_.candidates(result_.excitation, threads_);
    contained_ = containedIn(result_.candidates);
    fitSingles();
    say("screening all pairs", 0.4);
    const std::vector<Screened> pairs = screenPairs();
    if (needsFurtherEffects(evidenceOf(result_), criteria_)) {
      say("fitting the best pairs", 0.5);
      fitPairs(pairs);
      measured_.estimateNoise(result_.pairs.front(), result_);
      if (result_.pairs.front().fit.held_out > kSignificantRest * result_.noise) {
        say("fitting triples", 0.75);
        fitTriples();
      }
    }
    return std::move(result_);
  }

 private:
  void say(const std::string& stage, double fraction) const {
    if (progress_) {
      progress_(stage, fraction);
    }
  }

  // Model parameters as specified and as elements, and what was excited: three tasks that need nothing of each
  // other.
  void reEstimate() {
    const fit::Hypothesis model;
    const std::array<std::function<void()>, 3> tasks = {
        [&] {
          const fit::ParameterVector configured = fitter_.configured(model);
          result_.configured_gap = fitter_.gapAt(model, configured);
          result_.re_estimated.fit = fitter_.fit(model, configured, kBaseIterations);
          result_.as_configured = result_.re_estimated;
          result_.as_configured.fit.parameters = configured;
          result_.discretisation = measured_.discretisationError(result_.re_estimated);
        },
        [&] {
          const fit::HypothesisFitter& elements = measured_.elementFitter();
          result_.element_level = elements.fit(model, elements.configured(model), kBaseIterations);
        },
        [&] { result_.excitation = measured_.excitation(); }};
    fit::parallelFor(tasks.size(), threads_, [&](std::size_t i) { tasks[i](); });
  }

  void fitSingles() {
    for (int c = 0; c < static_cast<int>(result_.candidates.size()); ++c) {
      result_.singles.push_back({fit::makeHypothesis(result_.candidates, {c}), {}});
    }
    // What has to be simulated takes longest and comes first, so that no thread waits for it at the end.
    std::vector<FittedHypothesis*> order;
    for (FittedHypothesis& single : result_.singles) {
      order.push_back(&single);
    }
    std::stable_partition(order.begin(), order.end(),
                          [](const FittedHypothesis* single) { return !single->hypothesis.isAdditive(); });
    fit::parallelFor(order.size(), threads_, [&](std::size_t i) {
      const auto fit = order[i]->hypothesis.free_in_log.gain ? fitGains : fitSingle;
      fit(fitter_, result_.re_estimated, *order[i]);
    });
    std::copy_if(
        result_.singles.begin(), result_.singles.end(), std::back_inserter(ranked_),
        [](const FittedHypothesis& single) { return !single.hypothesis.last_resort && single.hypothesis.competes(); });
    sortByScore(ranked_);
    measured_.estimateNoise(ranked_.front(), result_);
  }

  // All pairs about the re-estimated model; on the way, what is visible and what a flexible fit could close.
  std::vector<Screened> screenPairs() {
    const Screening screening(fitter_, result_.candidates, result_.re_estimated, threads_);
    screening.measureVisibility(result_.noise, criteria_, result_);
    result_.implants = implantAll(fitter_, screening, threads_);
    std::vector<int> all;
    for (const FittedHypothesis& single : result_.singles) {
      if (single.hypothesis.competes()) {
        all.push_back(single.hypothesis.members.front());
      }
    }
    result_.surrogate_gap = screening.screen(all).error;
    return screening.pairs();
  }

  void fitPairs(const std::vector<Screened>& screened) {
    addBest(screened, kPairsFitted, result_.pairs);
    addPairs(ranked_[0], kLastResortsFitted);
    addPairs(ranked_[1], 0);
    addPairs(bestLastResort(), 0);
    addSets(withLawsApart(ranked_[0].hypothesis.members, contained_), result_.pairs);
    fitFrom(0, result_.pairs);
    fitSimpler(result_.pairs);
  }

  void fitTriples() {
    for (const FittedHypothesis* pair : worthAThird()) {
      addTriples(*pair);
    }
    if (result_.triples.empty()) {
      return;
    }
    fitFrom(0, result_.triples);
    fitSimpler(result_.triples);
    fitPartsOf(result_.triples.front());
    measured_.estimateNoise(result_.triples.front(), result_);
  }

  // The best pair, the best one without a trend, and the one that would be named, which need not be the best.
  std::vector<const FittedHypothesis*> worthAThird() const {
    std::vector<const FittedHypothesis*> pairs;
    const auto add = [&](const FittedHypothesis& pair) {
      if (std::find(pairs.begin(), pairs.end(), &pair) == pairs.end()) {
        pairs.push_back(&pair);
      }
    };
    for (const bool trends : {true, false}) {
      const auto best = std::find_if(result_.pairs.begin(), result_.pairs.end(), [&](const FittedHypothesis& pair) {
        return !pair.hypothesis.last_resort && (trends || !pair.hypothesis.free_in_log.trend);
      });
      if (best != result_.pairs.end()) {
        add(*best);
      }
    }
    const FittedHypothesis& named = result_.at(judge(evidenceOf(result_), criteria_).model);
    if (named.hypothesis.members.size() == 2) {
      add(named);
    }
    return pairs;
  }

  // The best of a screening, among them the best of those without a trend, which follows whatever is slow: the
  // judgement compares the others with them.
  void addBest(const std::vector<Screened>& screened, std::size_t most, std::vector<FittedHypothesis>& list) const {
    choose(result_.candidates, screened, most, list);
    const auto of_laws = std::find_if(screened.begin(), screened.end(), [&](const Screened& set) {
      return std::none_of(set.members.begin(), set.members.end(), [&](int member) {
        return result_.candidates[static_cast<std::size_t>(member)].free_in_log.trend;
      });
    });
    if (of_laws != screened.end()) {
      choose(result_.candidates, {*of_laws}, 1, list);
    }
  }

  // Fits those from a place on and sorts all, best first.
  void fitFrom(std::size_t first, std::vector<FittedHypothesis>& list) {
    fit::parallelFor(list.size() - first, threads_, [&](std::size_t i) {
      FittedHypothesis& fitted = list[first + i];
      fitFurther(fitter_, result_.candidates, bestPart(result_, fitted.hypothesis.members), fitted);
    });
    sortByScore(list);
  }

  // Until the best of a list has beside it all that the judgement compares it with: a simpler law in the place of each
  // that contains one.
  void fitSimpler(std::vector<FittedHypothesis>& list) {
    std::size_t fitted = 0;
    do {
      fitted = list.size();
      addSets(withSimplerLaws(list.front().hypothesis.members, contained_), list);
      fitFrom(fitted, list);
    } while (list.size() > fitted);
  }

  // Those of them that are not yet in the list, and may do what parameters do not.
  void addSets(const Sets& sets, std::vector<FittedHypothesis>& list) const {
    std::vector<Screened> wanted;
    for (const std::vector<int>& members : sets) {
      const bool compete = std::all_of(members.begin(), members.end(), [&](int member) {
        return result_.candidates[static_cast<std::size_t>(member)].competes();
      });
      if (compete) {
        wanted.push_back({members, 0.0});
      }
    }
    choose(result_.candidates, wanted, wanted.size(), list);
  }

  // The pairs within a triple: without them it is not known what each of the three is for.
  void fitPartsOf(const FittedHypothesis& triple) {
    const std::size_t fitted = result_.pairs.size();
    addSets(withoutOne(triple.hypothesis.members), result_.pairs);
    fitFrom(fitted, result_.pairs);
    fitSimpler(result_.pairs);
  }

  // Pairs of a single effect and what goes best with it, and so many with effects that can look like several others.
  void addPairs(const FittedHypothesis& single, std::size_t last_resorts) {
    if (!single.hypothesis.competes()) {
      return;
    }
    const Screening screening(fitter_, result_.candidates, single, threads_);
    const std::vector<int>& members = single.hypothesis.members;
    addBest(screening.additions(members), kAdditionsFitted, result_.pairs);
    if (last_resorts > 0) {
      choose(result_.candidates, screening.additions(members, Joining::last_resorts), last_resorts, result_.pairs);
    }
  }

  const FittedHypothesis& bestLastResort() const {
    return *std::min_element(
        result_.singles.begin(), result_.singles.end(), [](const FittedHypothesis& x, const FittedHypothesis& y) {
          return x.hypothesis.last_resort != y.hypothesis.last_resort ? x.hypothesis.last_resort
                                                                      : x.fit.score() < y.fit.score();
        });
  }

  void addTriples(const FittedHypothesis& pair) {
    const Screening screening(fitter_, result_.candidates, pair, threads_);
    addBest(screening.additions(pair.hypothesis.members), kAdditionsFitted, result_.triples);
    addSets(withLawsApart(pair.hypothesis.members, contained_), result_.triples);
  }

  const Measured& measured_;
  const fit::HypothesisFitter& fitter_;
  const Criteria& criteria_;
  int threads_;
  const ProgressCallback& progress_;
  Search result_;
  Sets contained_;                        // for each effect, the simpler ones that its law contains
  std::vector<FittedHypothesis> ranked_;  // singles but for last resorts, best first
};

// From the candidates as they are now.
void remakeHypotheses(Search& search) {
  for (auto* list : {&search.singles, &search.pairs, &search.triples}) {
    for (FittedHypothesis& fitted : *list) {
      const fit::FreeInLog free = fitted.hypothesis.free_in_log;  // gains may be common
      fitted.hypothesis = fit::makeHypothesis(search.candidates, fitted.hypothesis.members);
      fitted.hypothesis.free_in_log = free;
    }
  }
}

}  // namespace

const FittedHypothesis& Search::at(int hypothesis) const {
  if (hypothesis < Evidence::kFirstSingle) {
    return hypothesis == Evidence::kAsConfigured ? as_configured : re_estimated;
  }
  std::size_t place = static_cast<std::size_t>(hypothesis - Evidence::kFirstSingle);
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

void forgetUnitEffects(Search& search) {
  for (fit::Candidate& candidate : search.candidates) {
    for (fit::BasisTerm& term : candidate.terms) {
      term.unit_effect = nullptr;
    }
  }
  remakeHypotheses(search);
}

void findUnitEffects(Search& search, const std::vector<log::Record>& records, int threads) {
  fit::findUnitEffects(search.candidates, records, threads);
  remakeHypotheses(search);
}

Search search(const Measured& measured, const Criteria& criteria, int threads, const ProgressCallback& progress) {
  return Searcher(measured, criteria, threads, progress).run();
}

}  // namespace rubber_suspension::diagnosis
