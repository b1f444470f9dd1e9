// Runs virtual logs through all functions of measurement/, and counts findings over many logs.
#pragma once

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "measurement/perturb.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::measurement {

struct Examined {
  std::vector<RigFinding> findings;
  log::Record record;
  RigFit fit;
  Faults faults;

  const RigFinding* named(const std::string& name) const {
    for (const RigFinding& finding : findings) {
      if (finding.finding == name) {
        return &finding;
      }
    }
    return nullptr;
  }
};

inline Examined examine(const VirtualLog& virtual_log, const Elements& elements,
                        const io::RigTolerances& tolerances = {}) {
  Examined result;
  result.faults = findFaults(virtual_log.log);
  result.record = log::makeRecord(repaired(virtual_log.log, result.faults));
  const RigModel model({result.record}, {result.faults.usable()}, tolerances);
  const Simulate simulate = [&](const std::vector<Eigen::VectorXd>& displacements) {
    return simulateAll(elements, {result.record.dt}, displacements);
  };
  result.fit = model.fitAll(simulate({result.record.displacement}), simulate).front();
  result.findings = result.faults.findings;
  const auto of_rig = model.findings(0, result.fit);
  result.findings.insert(result.findings.end(), of_rig.begin(), of_rig.end());
  return result;
}

inline bool covers(const RigFinding& finding, double value) {
  return finding.interval_95[0] <= value && value <= finding.interval_95[1];
}

/// Returns rigs with every combination of law and motion, once per seed.
inline std::vector<VirtualRig> allRigs(unsigned seeds) {
  std::vector<VirtualRig> rigs;
  for (const Law law : {Law::maxwell, Law::friction, Law::progressive}) {
    for (const Motion motion : {Motion::sines, Motion::sweep, Motion::track, Motion::holds}) {
      for (unsigned seed = 1; seed <= seeds; ++seed) {
        VirtualRig rig;
        rig.law = law;
        rig.motion = motion;
        rig.seed = seed;
        rigs.push_back(rig);
      }
    }
  }
  return rigs;
}

/// Counts the rigs with the finding, the intervals that contain the true value, and all other findings.
struct Rate {
  int rigs = 0;
  int found = 0;
  int covered = 0;
  int others = 0;

  double share(int count) const { return static_cast<double>(count) / static_cast<double>(rigs); }
};

template <class Truth>
Rate rateOf(const std::vector<VirtualRig>& rigs, const Perturbation& perturbation, const std::string& finding,
            Truth truth, const std::string& label) {
  Rate rate;
  for (const VirtualRig& rig : rigs) {
    const VirtualLog log = runRig(rig, perturbation);
    const Examined examined = examine(log, elementsOf(rig));
    const RigFinding* hit = examined.named(finding);
    ++rate.rigs;
    rate.found += hit != nullptr ? 1 : 0;
    rate.covered += hit != nullptr && covers(*hit, truth(log)) ? 1 : 0;
    for (const RigFinding& other : examined.findings) {
      if (other.finding != finding) {
        ++rate.others;
        std::cout << "  " << label << ", law " << static_cast<int>(rig.law) << ", motion "
                  << static_cast<int>(rig.motion) << ", seed " << rig.seed << ": " << other.finding << ": "
                  << other.text << "\n";
      }
    }
  }
  std::cout << label << ": " << rate.rigs << " rigs, found " << rate.found << ", covered " << rate.covered
            << ", others " << rate.others << "\n";
  return rate;
}

}  // namespace rubber_suspension::measurement
