// Writes the reference page of the effects that a diagnosis may name.
#include "diagnosis/report/effect_reference.h"

#include <fmt/format.h>

#include <set>

#include "diagnosis/effect.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::report {
namespace {

// Returns the excitation of a spring of 3 MN/m at 2 mm and up to 10 Hz, for a minute, from 10 to 40 degC. The motion is
// in tension only, so that a contact that opens is a candidate. Candidates depend on no other property of an
// excitation.
fit::Excitation typicalExcitation() {
  fit::Excitation excitation;
  excitation.largest_displacement = 2e-3;
  excitation.largest_radius = 2e-3;
  excitation.stiffness = 3e6;
  excitation.force = 4e3;
  excitation.highest_force = 6e3;
  excitation.power = 100.0;
  excitation.highest_frequency = 10.0;
  excitation.mean_frequency = 5.0;
  excitation.highest_rate = 0.1;
  excitation.longest_duration = 60.0;
  excitation.slowest_loop = 0.5;
  excitation.dt = 1e-3;
  excitation.has_temperature = true;
  excitation.lowest_temperature = 10.0;
  excitation.highest_temperature = 40.0;
  return excitation;
}

std::string elementsOf(const fit::Candidate& candidate) {
  std::set<std::string> types;
  for (const auto& terms : {candidate.terms, candidate.along ? candidate.along({}) : candidate.curved}) {
    for (const fit::BasisTerm& term : terms) {
      types.insert(term.at(term.typical).type);
    }
  }
  const auto quoted = [](const std::string& name) { return "`" + name + "`"; };
  const std::string of_others = element::joined(candidate.contains, ", ", quoted);
  return element::joined(types, ", ", quoted) + (of_others.empty() ? "" : ", and those of " + of_others);
}

}  // namespace

std::string effectReference() {
  std::string text =
      "# Reference of the effects\n\n"
      "Written by the command `reference` from the list of candidates that `diagnose` searches. "
      "[parameters.md](parameters.md)\n"
      "describes the elements, [diagnosis.md](diagnosis.md) the search. An effect of the rig belongs to the "
      "measurement and not\n"
      "to the rubber: it explains a gap, but has no place in the model of a vehicle.\n\n"
      "| effect | of the | what it is: how it shows | elements |\n|---|---|---|---|\n";
  for (const fit::Candidate& candidate : diagnosis::candidates(typicalExcitation())) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", candidate.effect, candidate.on_rig ? "rig" : "rubber",
                        candidate.documentation, elementsOf(candidate));
  }
  return text;
}

}  // namespace rubber_suspension::diagnosis::report
