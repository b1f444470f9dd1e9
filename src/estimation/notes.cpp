// Notes on an estimation.
#include "rubber_suspension/estimation/notes.h"

#include <fmt/format.h>

#include "estimation/models.h"

namespace rubber_suspension::estimation {
namespace {

// A testing machine of class 1 (ISO 7500-1) measures forces to 1 %, so it cannot distinguish stiffnesses that differ by
// less.
constexpr double kStiffnessAccuracy = 0.01;

// A mass of 1 kg deflects this stiffness [N/m] by 1 cm. Components of vehicles are far stiffer.
constexpr double kSoftestStiffness = 1000.0;

void warnOfNeighbours(std::vector<std::string>& warnings, const Specification& specification, const std::string& upper,
                      const std::string& lower, const std::string& consequence) {
  const auto high = specification.find(upper);
  const auto low = specification.find(lower);
  if (high && low && *high > *low && *high - *low < kStiffnessAccuracy * *high) {
    warnings.push_back(fmt::format("{} is only {:.2g} % above {}: {}", inputText(specification, upper),
                                   100.0 * (*high / *low - 1.0), inputText(specification, lower), consequence));
  }
}

void warnOfSoftness(std::vector<std::string>& warnings, const Specification& specification) {
  for (const char* key : {"static_stiffness", "dynamic_stiffness"}) {
    const auto stiffness = specification.find(key);
    if (stiffness && *stiffness < kSoftestStiffness) {
      const WrittenUnit unit = specification.writtenUnit(key);
      const double number = *stiffness / unit.size;
      const std::string meant = unit.size == 1.0 ? fmt::format("; did you mean '{:g} kN/mm'?", number) : "";
      warnings.push_back(
          fmt::format("{} is softer than any suspension component{}", inputText(specification, key), meant));
      return;
    }
  }
}

// Returns a note with the stiffness at f_h, which a data sheet states; K_max is the limit at infinite frequency.
std::string highFrequencyNote(const Specification& specification, double high_frequency) {
  const double stiffness = std::abs(stiffnessAt(estimateTangent(Model::multi_maxwell, specification), high_frequency));
  const WrittenUnit unit = specification.writtenUnit("maximum_stiffness");
  return fmt::format(
      "K at high_frequency, {:.6g} Hz, is only {:.6g} {}, because maximum_stiffness is the limit for infinite "
      "frequency; to specify K at high_frequency, give high_frequency_stiffness",
      high_frequency, stiffness / unit.size, unit.name);
}

std::vector<std::string> multiMaxwellNotes(const Specification& specification) {
  const Band band = multiMaxwellBand(specification);
  std::vector<std::string> notes;
  if (specification.has("maximum_stiffness")) {
    notes.push_back(highFrequencyNote(specification, band.high_frequency));
  }
  if (!specification.has("low_frequency")) {
    notes.push_back(
        fmt::format("low_frequency is {:.6g} Hz, computed with f_l = n_M f_h/10^(n_M-1), which is a reconstruction of "
                    "the illegible Eq. 22 of the paper; for another value, give low_frequency",
                    band.low_frequency));
  }
  if (!specification.has("high_frequency")) {
    notes.push_back(
        fmt::format("high_frequency is {:.6g} Hz, computed from the loss angle; if several values are possible, this "
                    "is the lowest value above nominal_frequency",
                    band.high_frequency));
  }
  return notes;
}

// Adds a note if friction is at its limit over nearly all of the motion, like Coulomb friction, whose loss is largest.
void addSharpFriction(std::vector<std::string>& notes, Model model, const Specification& specification) {
  constexpr double kSharp = 0.02;  // share of the amplitude
  for (const element::ElementDescription& entry : estimateTangent(model, specification)) {
    if (entry.type == "friction" && entry.value("displacement") < kSharp * specification.at("nominal_amplitude")) {
      notes.push_back(fmt::format(
          "friction reaches half of its limit at z2 = {:.2g} m, {:.2g} % of the amplitude: this is nearly Coulomb "
          "friction, because the dynamic stiffness allows hardly more loss; for rubber, z2 is near the amplitude",
          entry.value("displacement"), 100.0 * entry.value("displacement") / specification.at("nominal_amplitude")));
    }
  }
}

}  // namespace

std::vector<std::string> estimationNotes(Model model, const Specification& specification) {
  if (!specification.preloads().empty()) {
    return {
        "the values of Maxwell elements and dashpots vary linearly between the preloads and are constant beyond them"};
  }
  if (model == Model::multi_maxwell) {
    return multiMaxwellNotes(specification);
  }
  std::vector<std::string> notes;
  if (model == Model::kelvin_voigt) {
    notes.push_back(
        "dynamic_stiffness is taken as the storage stiffness (Eq. 11): the loop's stiffness is K_n/cos(loss angle)");
    if (specification.has("static_stiffness")) {
      notes.push_back("static_stiffness is not used by kelvin_voigt, whose static stiffness is dynamic_stiffness");
    }
  }
  if (model == Model::friction_dashpot) {
    notes.push_back(
        "dynamic_stiffness is the stiffness between the turning points of the loop, where the dashpot has no force; "
        "the largest force occurs slightly earlier and is slightly higher");
  }
  if (model == Model::friction || model == Model::friction_dashpot || model == Model::berg) {
    addSharpFriction(notes, model, specification);
  }
  return notes;
}

std::vector<std::string> specificationWarnings(const Specification& specification) {
  std::vector<std::string> warnings;
  warnOfSoftness(warnings, specification);
  warnOfNeighbours(warnings, specification, "maximum_stiffness", "dynamic_stiffness",
                   "no measurement can distinguish these two values, but the estimated break frequencies depend on "
                   "their difference");
  warnOfNeighbours(warnings, specification, "dynamic_stiffness", "static_stiffness",
                   "no measurement can distinguish these two values, but the estimated damping or friction depends on "
                   "their difference");
  return warnings;
}

}  // namespace rubber_suspension::estimation
