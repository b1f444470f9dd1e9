// What rigs do to logs is found, with intervals that hold, and nothing is found where nothing was done.
#include "rubber_suspension/measurement/rig_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "measurement/perturb.h"
#include "rubber_suspension/measurement/bench_check.h"
#include "rubber_suspension/measurement/noise_floor.h"

namespace rubber_suspension::measurement {
namespace {

struct Found {
  std::vector<RigFinding> findings;
  RigFit fit;
  Faults faults;
};

Found examine(const VirtualLog& virtual_log, const Elements& elements, const io::RigTolerances& tolerances = {}) {
  Found found;
  found.faults = findFaults(virtual_log.log);
  const log::Record record = log::makeRecord(repaired(virtual_log.log, found.faults));
  const RigModel model({record}, {found.faults.usable()}, tolerances);
  const Simulate simulate = [&](const std::vector<Eigen::VectorXd>& displacements) {
    return simulateAll(elements, {record.dt}, displacements);
  };
  found.fit = model.fitAll(simulate({record.displacement}), simulate).front();
  found.findings = found.faults.findings;
  const auto of_rig = model.findings(0, found.fit);
  found.findings.insert(found.findings.end(), of_rig.begin(), of_rig.end());
  return found;
}

const RigFinding* named(const Found& found, const std::string& name) {
  for (const RigFinding& finding : found.findings) {
    if (finding.finding == name) {
      return &finding;
    }
  }
  return nullptr;
}

bool covers(const RigFinding& finding, double value) {
  return finding.interval_95[0] <= value && value <= finding.interval_95[1];
}

constexpr Law kLaws[] = {Law::maxwell, Law::friction, Law::progressive};
constexpr Motion kMotions[] = {Motion::sines, Motion::sweep, Motion::track, Motion::holds};

// All laws and motions, some seeds each.
template <class Check>
int forAllRigs(unsigned seeds, Check check) {
  int rigs = 0;
  for (const Law law : kLaws) {
    for (const Motion motion : kMotions) {
      for (unsigned seed = 1; seed <= seeds; ++seed) {
        VirtualRig rig;
        rig.law = law;
        rig.motion = motion;
        rig.seed = seed;
        check(rig);
        ++rigs;
      }
    }
  }
  return rigs;
}

struct Rate {
  int found = 0;
  int covered = 0;
  int others = 0;  // findings of another name
};

template <class Truth>
Rate rateOf(const Perturbation& p, const char* finding, Truth truth, unsigned seeds, const char* label) {
  Rate rate;
  int wrong_prints = 0;
  const int rigs = forAllRigs(seeds, [&](const VirtualRig& rig) {
    const VirtualLog log = runRig(rig, p);
    const Found found = examine(log, elementsOf(rig));
    const RigFinding* hit = named(found, finding);
    rate.found += hit != nullptr ? 1 : 0;
    rate.covered += hit != nullptr && covers(*hit, truth(log, *hit)) ? 1 : 0;
    for (const RigFinding& f : found.findings) {
      rate.others += f.finding != finding ? 1 : 0;
      if (f.finding != finding && wrong_prints++ < 4) {
        printf("  law %d motion %d seed %u: %s %g [%g %g] %s\n", (int)rig.law, (int)rig.motion, rig.seed,
               f.finding.c_str(), f.value, f.interval_95[0], f.interval_95[1], f.text.c_str());
      }
    }
    if (hit != nullptr && !covers(*hit, truth(log, *hit)) && wrong_prints++ < 8) {
      printf("  miss law %d motion %d seed %u: %g [%g %g] truth %g\n", (int)rig.law, (int)rig.motion, rig.seed,
             hit->value, hit->interval_95[0], hit->interval_95[1], truth(log, *hit));
    }
  });
  printf("%-28s of %d: found %d, covered %d, others %d\n", label, rigs, rate.found, rate.covered, rate.others);
  return rate;
}

TEST(RigModel, Probe) {
  const auto none = [](const VirtualLog&, const RigFinding&) { return 0.0; };
  Perturbation p;
  p.anti_alias = 0.1;
  rateOf(p, "none", none, 5, "anti-alias");
  p = {}; p.running_start = true;
  rateOf(p, finding::kRunningStart, [](const VirtualLog& l, const RigFinding&) { return l.transient; }, 5, "running");
}

TEST(NoiseFloor, Probe) {
  const auto run = [&](Perturbation p, bool model, const char* label) {
    std::map<std::string, std::vector<double>> ratios;
    forAllRigs(4, [&](const VirtualRig& rig) {
      const VirtualLog log = runRig(rig, p);
      const Found found = examine(log, elementsOf(rig));
      const log::Record record = log::makeRecord(repaired(log.log, found.faults));
      const NoiseFloor floor = noiseFloor(record, found.fit.residual, found.faults.usable(), 0.0);
      const Mask mask = found.faults.usable();
      ratios[floor.source].push_back(floor.smoothed / log.noise);
      ratios["all"].push_back(floor.smoothed / log.noise);
      const double s = noiseFromSpectrum(record, found.fit.residual, mask), r = noiseFromRepeats(record, found.fit.residual, mask), st = noiseFromStandstill(record, mask);
      if (s > 0) ratios["(spectrum)"].push_back(s / log.noise);
      if (r > 0) ratios["(repeats)"].push_back(r / log.noise);
      if (st > 0) ratios["(still)"].push_back(st / log.noise);
    });
    printf("%s:\n", label);
    for (auto& [name, v] : ratios) {
      std::sort(v.begin(), v.end());
      int in = 0;
      for (double x : v) in += x < 1.3 && x > 1 / 1.3;
      printf("   %s n %zu min %.2f med %.2f max %.2f within %d\n", name.c_str(), v.size(), v.front(), v[v.size() / 2], v.back(), in);
    }
  };
  Perturbation p;
  run(p, true, "white model");
  p.pink = true; run(p, true, "pink model");
  p = {}; p.anti_alias = 0.1; run(p, true, "aa model");
}

TEST(BenchCheck, Probe) {
  const auto run = [&](const Perturbation& p, const char* label) {
    std::map<std::string, int> names;
    forAllRigs(3, [&](const VirtualRig& rig) {
      const VirtualLog log = runRig(rig, p);
      const auto findings = checkBench(elementsOf(rig), {log::makeRecord(repaired(log.log, findFaults(log.log)))});
      names[findings.empty() ? "-" : findings.front().finding] += 1;
      if (!findings.empty() && names[findings.front().finding] == 1) printf("   %s\n", findings.front().text.c_str());
    });
    printf("%s:", label);
    for (const auto& [name, count] : names) printf(" %s %d", name.c_str(), count);
    printf("\n");
  };
  run({}, "clean");
  Perturbation p; p.sign = true; run(p, "sign");
  p = {}; p.swapped = true; run(p, "swapped");
  for (const double f : {1e3, 1e-3, 1e6, 1e-6, 9.81, 1/9.81, 25.4, 1/25.4, 4.448, 1/4.448, 6.5, 0.15}) { p = {}; p.factor = f; run(p, std::to_string(f).c_str()); }
  p = {}; p.running_start = true; p.force_zero = 0.03; p.displacement_zero = 0.03; p.spikes = 0.2; p.pink = true; run(p, "messy");
  p = {}; p.delay = 60; run(p, "delay 60");
}

}  // namespace
}  // namespace rubber_suspension::measurement

