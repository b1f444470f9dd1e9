// From a proposal to sentences.
#include "diagnosis/words/experiment_text.h"

#include <fmt/format.h>

#include "diagnosis/words/text.h"

namespace rubber_suspension::diagnosis::words {
namespace {

using experiment::NextExperiment;
using experiment::Proposal;
using experiment::WiderLimit;

std::string limitText(const Diagnosis& d, const NextExperiment& next) {
  switch (next.limit) {
    case WiderLimit::stroke:
      return "a stroke of " + quantity(next.wider.stroke.half, unitOf(d, "m"));
    case WiderLimit::speed:
      return fmt::format("{:.3g} Hz and a speed of {}", next.wider.frequency,
                         quantity(next.wider.speed, unitOf(d, "m/s")));
    default:
      return "a log of " + quantity(next.wider.duration, "s");
  }
}

std::string openText(double left, const NextExperiment& next) {
  return fmt::format("{:.2g} of {:.2g} bit", left, next.open);
}

std::string proposedText(const Diagnosis& d, const NextExperiment& next) {
  const std::string nearest =
      next.nearest.empty()
          ? ""
          : fmt::format("If {} is right, {}, fitted anew, would be off by {} there. ", next.names.front(), next.nearest,
                        quantity(next.proposed.difference, unitOf(d, "N")));
  return fmt::format(
      "{}. It is to decide between {}. {}Of what is open about the names, {} are expected to remain. The right one "
      "alone remains in {} % of cases.",
      inUnits(d, next.motion), enumerated(next.names), nearest, openText(next.open_after, next),
      chance(next.proposed.probability));
}

std::string noneText(const Diagnosis& d, const NextExperiment& next) {
  return fmt::format(
             "None within the limits: of what is open about the names of {}, {} would remain. The motion that tells "
             "most is this: {}. ",
             enumerated(next.names), openText(next.open_after, next), inUnits(d, next.motion)) +
         (next.proposal == Proposal::beyond_limits
              ? fmt::format("It would take {}: {}, after which {} remain.", limitText(d, next),
                            inUnits(d, next.wider_motion), openText(next.wider_open_after, next))
              : "Twice the stroke, twice the speed or five times the time would not do.");
}

}  // namespace

std::string experimentText(const Diagnosis& d, const NextExperiment& next) {
  switch (next.proposal) {
    case Proposal::agrees:
      return "None is needed: the model agrees with the measurement as far as these logs can show.";
    case Proposal::sure:
      return fmt::format("None is needed: the verdict stands at {} %.", chance(d.answer.probability));
    case Proposal::no_rival:
      return "None: no second explanation was fitted.";
    case Proposal::same_effects:
      return fmt::format("None: {} name the same effects.", enumerated(next.names));
    case Proposal::no_motion:
      return "None: no motion of the menu stays within the limits of stroke, speed, force and duration.";
    case Proposal::within_limits:
      return proposedText(d, next);
    default:
      return noneText(d, next);
  }
}

}  // namespace rubber_suspension::diagnosis::words
