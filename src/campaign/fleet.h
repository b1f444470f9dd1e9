// What a fleet says that a single component cannot: components of one type share values, scatter and causes.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.h"
#include "campaign/random_effects.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::campaign {

struct Record;

/// How far a parameter of one component is from its configured value: logarithm of the ratio.
struct ParameterChange {
  double logarithm = 0.0;
  double squares = 0.0;         ///< of the logarithms that each log alone gives, about their mean
  std::size_t logs = 0;         ///< that give one each
  double standard_error = 0.0;  ///< where the estimate itself tells it; else from all logs of the type
};

using ParameterChanges = std::map<std::string, ParameterChange>;  ///< by name

/// What may be the cause, by a component's own logs: effects, or "parameter_error" where values may be all that is
/// wrong.
struct OwnExplanation {
  std::string cause;  ///< "friction + creep"
  double probability = 0.0;
};

/// What is known of one component by its own logs.
struct FleetComponent {
  std::string id;  ///< of its job
  std::string name;
  std::string report;                         ///< path relative to the campaign's folder; may be empty
  std::optional<diagnosis::Verdict> verdict;  ///< none for estimate
  std::vector<std::string> effects;           ///< named
  std::vector<OwnExplanation> explanations;   ///< by its own logs, what is said first
  std::string test_rig;
  /// Nothing where an effect is named: the values that go with it depend on the form that it is given.
  ParameterChanges parameters;
};

/// A parameter over the components of a type.
struct FleetParameter {
  std::string name;
  std::vector<std::size_t> components;    ///< places in FleetType::components
  std::vector<Observation> observations;  ///< of the logarithm of re-estimated over configured value
  std::optional<RandomEffects> model;     ///< nothing for a few components
  bool wrong_for_all = false;             ///< the fleet shows that the configured value is wrong for the type
};

/// In how many components an effect is the cause.
struct EffectShare {
  std::string effect;                ///< or several, "friction + creep"; "" for none
  std::size_t named = 0;             ///< components that name it
  std::size_t sure = 0;              ///< components whose own logs leave no other in its place
  double share = 0.0;                ///< of the components that are sure of their cause
  std::array<double, 2> interval{};  ///< 95 %
};

/// A value that is farther than RandomEffects::z_limit and kWorthSaying from the median of its type.
struct StandOut {
  std::size_t component;
  std::string parameter;
  double ratio;  ///< re-estimated over configured value
  double robust_z;
};

/// A component of which the fleet says another thing than its own logs.
struct ChangedVerdict {
  std::size_t component;
  std::string from;
  std::string to;
  std::string reason;
};

struct FleetType {
  std::string name;
  std::vector<FleetComponent> components;
  std::map<std::string, std::size_t> verdicts;
  std::vector<EffectShare> effects;  ///< most frequent first
  std::vector<FleetParameter> parameters;
  std::vector<StandOut> stand_outs;
  std::vector<ChangedVerdict> changed;
};

/// The mean of a parameter over the components of one type that were tested on one rig.
struct RigMean {
  std::string rig;  ///< "" where the jobs file names none
  std::string type;
  std::string parameter;
  std::size_t components = 0;
  double mean = 0.0;  ///< of the logarithm of re-estimated over configured value
};

struct FleetFindings {
  std::vector<FleetType> types;
  std::vector<RigMean> rigs;  ///< by rig, type and parameter, where a rig had several types
};

/// Less than this logarithm is within what a bench can hold: no value is said to be wrong for it, and none stands out.
constexpr double kWorthSaying = 0.02;

/// A member of a set that a component's logs cannot tell apart is decided where it becomes as probable as this.
constexpr double kDecided = 0.95;

/// Collects components job by job, in the order of the manifest, and looks at them together.
///
/// Parameters: the hierarchical model of random_effects.h for each. The error of a component's value follows from the
/// scatter of its logs, each fitted alone, pooled over the type. Components with a named effect take no part.
///
/// Rigs: a rig that gives way takes more of a stiff type than of a soft one, a wrong gain takes the same of all. The
/// means by rig and type show it; nothing is decided by them.
///
/// Causes: the components whose own logs leave one cause only are draws from a multinomial distribution of unknown
/// shares (Jeffreys' prior, 1/2 for each cause). The expected shares are the prior of every other component of the
/// type, for which its own probabilities stand as its likelihood. Components that are not sure themselves add
/// nothing to the shares: what is confounded in all of them stays so, because the same programme on the same rig errs
/// the same way in all.
class Fleet {
 public:
  /// Jobs that failed, and replays, add nothing.
  void add(const Job& job, const Record& record);

  /// By the names of types and rigs.
  FleetFindings analyse() const;

 private:
  std::map<std::string, std::vector<FleetComponent>> components_;
};

}  // namespace rubber_suspension::campaign
