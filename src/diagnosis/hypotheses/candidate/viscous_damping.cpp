// Candidate effect: viscous damping, which may depend on the displacement, or nonlinearly on the rate.
#include <cmath>
#include <numeric>

#include "diagnosis/effect.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addViscousDamping(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double typical = 0.05 * excitation.stiffness / (2.0 * element::kPi * excitation.highest_frequency);
  candidate.terms = {fit::additiveTerm("dashpot", "damping", typical, {{"order", {2.0}}})};
  for (const double exponent : {0.5, 2.0}) {  // for shear thinning, and for flow through an orifice
    candidate.terms.push_back(
        fit::additiveTerm("power_dashpot", "damping", typical,
                          {{"reference_rate", {excitation.highest_rate}}, {"exponent", {exponent}}}));
  }
  for (const double share : {0.3, 1.0}) {  // for shear thinning up to a limit of the force
    candidate.terms.push_back(
        fit::additiveTerm("thinning_dashpot", "damping", typical, {{"half_rate", {share * excitation.highest_rate}}}));
  }
  for (const double power : {1.0, 4.0}) {  // for fluid that is squeezed out of a closing gap
    for (const double side : {1.0, -1.0}) {
      candidate.terms.push_back(fit::additiveTerm(
          "position_dashpot", "damping", typical,
          {{"reference_displacement", {excitation.largest_displacement}}, {"power", {power}}, {"side", {side}}}));
      candidate.terms.back().of_a_side = true;
    }
  }
}

// Returns the force of an entry at a rate and at zero displacement.
double forceAtRate(const element::ElementDescription& entry, double rate) {
  const double linear = entry.value("damping") * rate;
  if (entry.type == "power_dashpot") {
    return linear * std::pow(rate / entry.value("reference_rate"), entry.value("exponent") - 1.0);
  }
  if (entry.type == "thinning_dashpot") {
    return linear / (1.0 + rate / entry.value("half_rate"));
  }
  return entry.type == "position_dashpot" ? linear * std::pow(0.5, entry.value("power")) : linear;
}

// Returns the damping of a single linear dashpot. Of other laws, logs determine only the force at the highest rate.
std::vector<HeadlineValue> forceOrDamping(const Effect::Entries& entries, const fit::Excitation& excitation) {
  if (entries.size() == 1 && entries.front().type == "dashpot") {
    return movedOf(entries);
  }
  const double force = std::accumulate(entries.begin(), entries.end(), 0.0, [&](double sum, const auto& entry) {
    return sum + forceAtRate(entry, excitation.highest_rate);
  });
  return {{"force_at_highest_rate", "N", force, true}, {"highest_rate", "m/s", excitation.highest_rate, false}};
}

Effect viscousDamping() {
  Effect effect{40, "viscous_damping", "dashpot: loss force grows with frequency", false, addViscousDamping};
  effect.sizes = forceOrDamping;
  effect.labels = {{"force_at_highest_rate", "force"}, {"highest_rate", "at"}};
  return effect;
}

const EffectEntry kViscousDamping(viscousDamping());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
