// A candidate effect: what a model may lack, as entries for `add:` whose scales a fit determines.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// What the logs have in common; candidates choose their grids by it.
struct Excitation {
  double largest_displacement = 0.0;  ///< largest |z| [m]
  double stiffness = 0.0;             ///< force over displacement, by their standard deviations [N/m]
  double force = 0.0;                 ///< standard deviation of the force [N]
  double power = 0.0;                 ///< mean of |force x rate| [W]
  double highest_frequency = 0.0;     ///< [Hz]
  double highest_rate = 0.0;          ///< largest |dz/dt| [m/s]
  double longest_duration = 0.0;      ///< [s]
  double dt = 0.0;                    ///< [s]
  double mass_bandwidth = 0.0;        ///< of the filter with which the node errs least by a mass [Hz]; 0: none
};

Excitation summarise(const std::vector<log::Record>& records);

/// One entry for `add:` and the scale that a fit determines. The component's force is taken as differentiable in the
/// scale; at scale 0 the entry is left out.
struct Atom {
  std::function<element::ElementDescription(double scale)> at;
  double typical = 1.0;  ///< a scale of the order that a visible effect has
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  bool additive = true;  ///< the force is that of the component plus scale times that of the entry alone
  bool refines = false;  ///< much like its fellows, so that a fit far from its end would confuse them
  bool on_rig = false;   ///< additive whatever effects act on the specimen
  /// A force effect whose factor is 1 less the scale times a share that the displacement alone decides.
  bool softening = false;
  /// Force of the entry alone at scale 1 where samples to come tell it better than the entry, which may not look ahead.
  std::function<Eigen::VectorXd(const log::Record&)> exact;
  /// What the entry does to each log at scale 1: the force that it adds [N], or the share of the specimen's force that
  /// it takes [-]. Set by Fitter::precompute for additive and softening atoms.
  std::shared_ptr<const std::vector<Eigen::VectorXd>> unit_effect;
};

/// An unmodelled effect by its name in reports. Its atoms span the shapes that the effect's law can take: their scales
/// are bounded such that only physical laws can be composed (dissipating friction, stiffening stops, ...).
struct Candidate {
  std::string effect;
  std::string documentation;  ///< what it is and its signature, one sentence
  bool on_rig = false;        ///< belongs to the rig, not to the rubber
  std::vector<Atom> atoms;
  bool free_trend = false;   ///< a slow trend of each log belongs to it, which no model run reproduces
  bool last_resort = false;  ///< named only where no other effects explain the gap
};

/// All candidates for these logs, in the order of the reference page. To add one: a file in candidate/ and its line
/// here.
std::vector<Candidate> candidates(const Excitation& excitation);

/// An atom that scales one parameter of an element whose force is linear in it, the others being given.
Atom additiveAtom(const std::string& type, const std::string& scaled, double typical,
                  const element::ParameterValues& others = {});

}  // namespace rubber_suspension::fit
