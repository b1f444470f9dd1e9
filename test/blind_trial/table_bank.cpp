// Diagnoses tables of virtual components with noise, for the figures of docs/tables.md.
// Usage: table_bank NOISE TABLES [few]. NOISE is the relative noise of K*, TABLES the number of tables per component,
// and `few` selects 12 rows instead of 24.
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "diagnosis/laboratory.h"
#include "rubber_suspension/diagnosis/table_diagnosis.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::diagnosis;

const char* const kKelvinVoigt =
    "{model: kelvin_voigt, specification: {dynamic_stiffness: 1.3e6, nominal_frequency: 4.0, relative_damping: 0.05}";

struct Case {
  std::string configured;
  std::string truth;
  std::string added;
  std::string right;  // name of the effect, or the verdict if no effect is right
};

const std::vector<Case>& cases() {
  static const std::vector<Case> list = {
      {kZener, kZener, "", "none"},
      {kManyMaxwell, kManyMaxwell, "", "none"},
      {kZener, kZenerOff, "", "parameter_error"},
      {kZener, kZener, "{type: friction, maximum_force: 200, displacement: 4.0e-4}", "friction"},
      {kZener, kZener, "{type: coulomb_friction, maximum_force: 60, stiffness: 3.0e6}", "friction"},
      {kZener, kZener, "{type: maxwell, stiffness: 5.0e5, break_frequency: 15}", "relaxation"},
      {kZener, kZener, "{type: maxwell, stiffness: 5.0e5, break_frequency: 0.6}", "relaxation"},
      {kZener, kZener, "{type: dashpot, damping: 2000}", "viscous_damping"},
      {kZener, kZener, "{type: progressive_stiffness, cubic: 6.0e10}", "progressive_stiffness"},
      {kZener, kZener, "{type: bump_stop, stiffness: 2.0e6, gap: 1.2e-3}", "bump_stop"},
      {kManyMaxwell, kManyMaxwell, "{type: series_compliance, stiffness: 3.0e7}", "series_compliance"},
      {kZener, kZener, "{type: free_play, gap: 3.0e-5}", "free_play"},
      {kZener, kZener, "{type: inertia, mass: 20}", "inertia"},
      {kZener, kZener, "{type: time_delay, delay: 2.0e-3}", "time_delay"},
      {kZener, kZener, "{type: nonlinear_maxwell, stiffness: 4.0e5, break_frequency: 3, displacement: 2.0e-4}",
       "rate_amplitude_coupling"},
      {kZener, kZener, "{type: sliding_maxwell, stiffness: 4.0e5, break_frequency: 3, yield_displacement: 2.0e-4}",
       "rate_amplitude_coupling"},
      {kManyMaxwell, kManyMaxwell, "{type: friction, maximum_force: 800, displacement: 5.0e-4}", "friction"},
      {kZener, kZenerOff, "{type: friction, maximum_force: 200, displacement: 4.0e-4}", "friction"},
      {kKelvinVoigt, kKelvinVoigt, "{type: maxwell, stiffness: 3.0e5, break_frequency: 2}", "relaxation"}};
  return list;
}

fit::MeasuredTable tableOf(const Case& one, double noise, unsigned seed, bool few) {
  const io::ComponentDescription truth = one.added.empty() ? without(one.truth) : with(one.truth, one.added);
  Laboratory laboratory(seed, noise, 3000);
  return few ? laboratory.table(truth, {0.5, 2.0, 5.0, 15.0}, {1e-4, 5e-4, 2e-3}) : laboratory.table(truth);
}

std::string setOf(const Diagnosis& diagnosis) {
  std::string text;
  for (const auto& set : diagnosis.answer.confounded) {
    for (const std::string& member : set) {
      text += " " + member;
    }
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const double noise = argc > 1 ? std::atof(argv[1]) : 0.01;
  const unsigned tables = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 4;
  const bool few = argc > 3;
  int right = 0;
  for (const Case& one : cases()) {
    for (unsigned seed = 1; seed <= tables; ++seed) {
      const auto found = diagnoseTable(without(one.configured), tableOf(one, noise, seed, few));
      const std::string first =
          found.answer.effects.empty() ? toString(found.answer.verdict) : found.answer.effects.front();
      const bool is_right = first == one.right && found.answer.effects.size() < 2;
      right += is_right ? 1 : 0;
      if (!is_right) {
        fmt::print("{} {}: {} {}; set:{}\n", one.right, seed, toString(found.answer.verdict), first, setOf(found));
      }
    }
  }
  fmt::print("right first {} of {}\n", right, cases().size() * tables);
  return 0;
}
