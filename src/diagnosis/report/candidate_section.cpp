// Which effects were weighed.
#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/results/headline.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::report {
namespace {

using words::percent;

constexpr double kLikely = 0.01;  // less probable ones are folded

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool isNamed(const Diagnosis& d, const CandidateResult& candidate) {
  return contains(d.answer.effects, candidate.effect);
}

std::string parametersText(const Diagnosis& d, const CandidateResult& candidate) {
  return element::joined(results::headlineValuesOf(candidate.add), ", ", [&](const results::HeadlineValue& value) {
    return words::labelOf(value.name) + " " + words::quantity(value.value, words::unitOf(d, value.unit));
  });
}

std::string closedText(const CandidateResult& c) {
  return fmt::format("{} % ({} to {} %)", words::wholePercent(c.closed),
                     words::wholePercent(std::min(1.0, c.interval[0])),
                     words::wholePercent(std::min(1.0, c.interval[1])));
}

words::Row rowOf(const Diagnosis& d, const CandidateResult& c) {
  return {fmt::format("<b>{}</b><br><span class=note>{}{}</span>", words::escape(c.effect),
                      words::escape(c.documentation), c.on_rig ? " (on the rig, not in the rubber)" : ""),
          words::chance(c.probability) + " %", percent(c.gap), closedText(c),
          words::escape(isNamed(d, c) ? parametersText(d, c) : whyOut(d, c))};
}

std::string notTestable(const Diagnosis& d) {
  const auto hidden = element::those(d.candidates, [](const CandidateResult& c) { return !c.testable; });
  const auto names = element::each(hidden, [](const CandidateResult& c) { return words::spoken(c.effect); });
  return names.empty() ? "Every candidate would show in " + words::sourceOf(d) + "."
                       : "A typical " + words::enumerated(names) + " would not show in " + words::sourceOf(d) +
                             ", so whether it is there stays open.";
}

const char* const kProbability =
    "The probability of an effect is the sum over all sets of effects that contain it. It rests on cases of known "
    "cause; docs/accuracy.md says how often a stated probability is right.";

}  // namespace

std::string whyOut(const Diagnosis& d, const CandidateResult& c) {
  if (isNamed(d, c)) {
    return "";
  }
  if (d.table && contains(d.table->never_shown, c.effect)) {
    return "no table of settled loops shows it: record a log";
  }
  if (!c.testable) {
    return fmt::format("not testable with {}: other parameter values leave {} % of a typical one, too little to see",
                       words::sourceOf(d), words::wholePercent(c.visible_share));
  }
  if (c.interval[0] <= 0.0) {
    return "on further logs it may remove nothing";
  }
  if (d.answer.effects.empty()) {
    return fmt::format("leaves {} of the {} that re-estimation leaves", percent(c.gap),
                       percent(d.gaps.unseen.re_estimated));
  }
  return c.gap > d.gaps.unseen.augmented
             ? fmt::format("leaves {}, where what is named leaves {}", percent(c.gap), percent(d.gaps.unseen.augmented))
             : fmt::format("leaves {}, no more than what is named, and is less probable", percent(c.gap));
}

std::string candidateSection(const Diagnosis& d) {
  const words::Row titles = {"effect", "#probability", "#gap with it alone", "#removes (95 %)",
                             "parameters, or why out"};
  std::vector<words::Row> shown;
  std::vector<words::Row> rest;
  for (const CandidateResult& c : d.candidates) {
    (c.probability >= kLikely || isNamed(d, c) ? shown : rest).push_back(rowOf(d, c));
  }
  std::string html =
      shown.empty() ? "<p>No candidate reaches a probability of 1 %.</p>\n" : words::table(titles, shown);
  html += fmt::format(
      "<p>No gap: {} %. Wrong values of the model alone: {} %. None of these: {} %. All candidates at once, as a "
      "flexible fit without claim to a cause, "
      "would leave a gap of {} on parts of {} held out.</p>\n",
      words::chance(d.answer.posterior.none), words::chance(d.answer.posterior.parameter_error),
      words::chance(d.answer.posterior.none_of_these), percent(d.workings->search.surrogate_gap), words::sourceOf(d));
  html += fmt::format("<p class=note>{}</p>\n<p>{}</p>\n", kProbability, words::escape(notTestable(d)));
  const std::string title = fmt::format("{} candidates below 1 %, and why they are out", rest.size());
  return rest.empty() ? html : html + words::folded(title, words::table(titles, rest));
}

}  // namespace rubber_suspension::diagnosis::report
