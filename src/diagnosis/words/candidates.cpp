// States why a candidate effect is named or not.
#include "diagnosis/words/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "diagnosis/effect.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::words {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Out reasonOf(const Diagnosis& d, const CandidateResult& c) {
  if (contains(d.answer.effects, c.effect)) {
    return Out::named;
  }
  if (d.table && contains(d.table->never_shown, c.effect)) {
    return Out::of_no_table;
  }
  if (!c.testable) {
    return Out::not_testable;
  }
  if (c.interval[0] <= 0.0) {
    return Out::removes_nothing;
  }
  if (d.answer.effects.empty()) {
    return Out::gap_remains;
  }
  return c.gap > d.gaps.unseen.augmented ? Out::more_than_named : Out::less_probable;
}

std::string whyOut(const Diagnosis& d, const CandidateResult& c) {
  switch (reasonOf(d, c)) {
    case Out::named:
      return "";
    case Out::of_no_table:
      return "a table of settled loops cannot show this effect: record a log";
    case Out::not_testable:
      return fmt::format(
          "not testable with {}: other parameter values absorb all but {} % of a typical effect; this is too little to "
          "detect",
          sourceOf(d), wholePercent(c.visible_share));
    case Out::removes_nothing:
      return "the effect may remove nothing of the gap on further logs";
    case Out::gap_remains:
      return fmt::format("the gap is {} with the full law of this effect, and {} with other parameter values only",
                         percent(c.gap), percent(d.gaps.unseen.re_estimated));
    case Out::more_than_named:
      return fmt::format("the gap is {} with the full law of this effect, and {} with the named effects",
                         percent(c.gap), percent(d.gaps.unseen.augmented));
    default:
      return fmt::format("the gap with the full law of this effect is no larger ({}), but the effect is less probable",
                         percent(c.gap));
  }
}

std::string notTestableText(const Diagnosis& d) {
  const auto hidden = element::those(d.candidates, [](const CandidateResult& c) { return !c.testable; });
  const auto names = element::each(hidden, [](const CandidateResult& c) { return spoken(c.effect); });
  return names.empty() ? "Every candidate would show in " + sourceOf(d) + "."
                       : "A typical " + enumerated(names) + " would not show in " + sourceOf(d) +
                             ", so these effects remain possible.";
}

std::string numbersText(const Diagnosis& d, const CandidateResult& candidate) {
  return element::joined(headlineValuesOf(candidate.add), ", ", [&](const HeadlineValue& value) {
    return labelOf(value.name) + " " + quantity(value.value, unitOf(d, value.unit));
  });
}

}  // namespace rubber_suspension::diagnosis::words
