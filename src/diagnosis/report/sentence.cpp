// Sentences of the report.
#include "diagnosis/report/sentence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnosis/augmented.h"
#include "diagnosis/report/experiment.h"

namespace rubber_suspension::diagnosis {
namespace {

std::string setsText(const std::vector<std::vector<std::string>>& sets) {
  std::string text;
  for (const auto& set : sets) {
    if (set.size() > 1) {
      text += (text.empty() ? "" : "; ") + fmt::format("{}", fmt::join(set, ", "));
    }
  }
  return text;
}

std::string membersText(const Search& search, const FittedHypothesis& fitted) {
  std::string text;
  for (const int member : fitted.hypothesis.members) {
    text += (text.empty() ? "" : " + ") + search.candidates[static_cast<std::size_t>(member)].effect;
  }
  return text.empty() ? "the model as it is" : text;
}

// The best explanation that is not the one judged, of as many effects, or of one.
const FittedHypothesis* rivalOf(const Search& search, const FittedHypothesis& judged) {
  const std::vector<int>& members = judged.hypothesis.members;
  const FittedHypothesis* rival = nullptr;
  for (const auto* list : {&search.singles, &search.pairs}) {
    for (const FittedHypothesis& other : *list) {
      const std::size_t count = other.hypothesis.members.size();
      const bool counts = count == std::max<std::size_t>(1, members.size()) && other.hypothesis.members != members;
      if (counts && (rival == nullptr || other.fit.held_out < rival->fit.held_out)) {
        rival = &other;
      }
    }
  }
  return rival;
}

std::string gapText(double gap) { return fmt::format("{:.1f} %", 100.0 * gap); }

std::string unknownSentence(const Judgement& judgement, const Gap& gap) {
  if (judgement.only_unseen_logs_differ) {
    return fmt::format(
        "The logs of the fit confirm the model, the unseen ones do not (gap {}, noise floor {}): they show something "
        "that the logs of the fit do not. Fit logs that cover the same range.",
        gapText(gap.augmented), gapText(gap.noise_floor));
  }
  return fmt::format(
      "The gap of {} is real (noise floor {}) and no effect of the list explains it: see where it lies before you "
      "trust the model there.",
      gapText(gap.re_estimated), gapText(gap.noise_floor));
}

}  // namespace

std::string sentence(const Judgement& judgement, const Diagnosis& diagnosis) {
  const Gap& gap = diagnosis.gap;
  const std::string names = fmt::format("{}", fmt::join(diagnosis.effects, " and "));
  const std::string closes = fmt::format(
      "adding {} closes {:.0f} % of what re-estimation leaves (gap {} to {}, noise floor {})", names,
      100.0 * diagnosis.closed, gapText(gap.re_estimated), gapText(gap.augmented), gapText(gap.noise_floor));
  switch (judgement.verdict) {
    case Verdict::none:
      return fmt::format("The model agrees with the measurement: the gap of {} is at the noise floor of {}.",
                         gapText(gap.as_configured), gapText(gap.noise_floor));
    case Verdict::parameter_error:
      return fmt::format("The model's parameters are off: re-estimating them reduces the gap from {} to {}.",
                         gapText(gap.as_configured), gapText(gap.re_estimated));
    case Verdict::named:
      return fmt::format("The model lacks {}: {}.", names, closes);
    case Verdict::confounded:
      return fmt::format("The model most probably lacks {}: {}. These logs cannot tell apart: {}.", names, closes,
                         setsText(diagnosis.confounded));
    case Verdict::partly:
      return fmt::format(
          "The model lacks {}, and something else: {}; a significant part of the gap remains unexplained.", names,
          closes);
    default:
      return unknownSentence(judgement, gap);
  }
}

std::string nextExperiment(const Search& search, const Judgement& judgement, const fit::ModelParameters& model) {
  constexpr double kLeastNoise = 1e-4;  // of the force
  const FittedHypothesis& judged = search.at(judgement.model);
  const FittedHypothesis* rival = rivalOf(search, judged);
  if (rival == nullptr) {
    return "None of the menu: no second explanation was fitted.";
  }
  const auto menu = experimentMenu(search.excitation);
  const double noise = std::max(search.noise, kLeastNoise) * search.excitation.force;
  const auto best = mostTelling(menu, augmentedDescription(model, judged).allElements(),
                                augmentedDescription(model, *rival).allElements(), noise);
  if (best.experiment == nullptr) {
    return "None of the menu would tell the explanations apart.";
  }
  return fmt::format("{}: there {} and {} differ by {:.1f} times the noise floor.", best.experiment->description,
                     membersText(search, judged), membersText(search, *rival), best.difference);
}

}  // namespace rubber_suspension::diagnosis
