// Results of a campaign at its end: one table, in the order of the manifest, and what a fleet shows
// that a single component cannot: how often a verdict or an effect occurs, and how values scatter.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/manifest.h"
#include "campaign/record.h"

namespace rubber_suspension::campaign {

/// How often something occurs among the diagnosed components of a type.
struct Share {
  std::string name;
  std::size_t components = 0;
  double share = 0.0;
  std::array<double, 2> interval{};  ///< 95 %, by Jeffreys' prior
};

/// How a number is distributed over components.
struct Distribution {
  std::size_t components = 0;
  double median = 0.0;
  std::array<double, 2> quartiles{};
  /// 95 % for the median, between two of the values whatever their distribution (Thompson, Ann. Math. Statist. 7 (1936)
  /// 122-128); nothing for fewer than six.
  std::optional<std::array<double, 2>> median_interval;
};

/// Of one value at least.
Distribution distributionOf(std::vector<double> values);

/// One component as its own logs show it.
struct FleetComponent {
  std::string id;  ///< of its job
  std::string name;
  std::string report;  ///< path relative to the campaign's folder; may be empty
  std::string test_rig;
  Findings findings;
};

/// A value of one component: logarithm of re-estimated over configured value.
struct ComponentValue {
  std::size_t component;  ///< place in FleetType::components
  std::string parameter;
  double value;
};

/// A parameter over the components of a type, or those of them that were tested on one rig.
struct FleetParameter {
  std::string rig;  ///< "" where the jobs file names none, and for all rigs together
  std::string type;
  std::string parameter;
  Distribution distribution;
};

struct FleetType {
  std::string name;
  std::vector<FleetComponent> components;
  std::vector<Share> verdicts;
  std::vector<Share> effects;  ///< that are named, most frequent first
  std::vector<FleetParameter> parameters;
  /// Farther from the quartiles than four times their distance, and from the median by more than a bench holds.
  std::vector<ComponentValue> far_out;
};

struct FleetFindings {
  std::vector<FleetType> types;
  /// By rig, type and parameter, where a rig had several types: one that gives way takes more of a stiff type than of a
  /// soft one, a wrong gain takes the same of all.
  std::vector<FleetParameter> rigs;
};

/// Less than this logarithm is within what a bench can hold: no value is far out for it.
constexpr double kWorthSaying = 0.02;

/// Of fewer values none is far out.
constexpr std::size_t kFewestComponents = 6;

/// Collects components job by job, in the order of the manifest, and counts.
class Fleet {
 public:
  /// Jobs that failed, and replays, add nothing.
  void add(const Job& job, const Record& record);

  /// By the names of types and rigs.
  FleetFindings analyse() const;

 private:
  std::map<std::string, std::vector<FleetComponent>> types_;
};

struct CollectSummary {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t missing = 0;          ///< broken records among them
  std::vector<std::string> broken;  ///< what is wrong with those
  std::string page_problem;         ///< why there is no fleet.html; empty where there is
};

/// Write table.csv, table.json, fleet.json and fleet.html: the same bytes however the jobs were worked off, for nothing
/// of time, place or order of the work stands in them. A job without a result has a row nevertheless. Throws
/// std::runtime_error.
CollectSummary collect(const Manifest& manifest, const std::string& folder);

inline std::string tableCsvPath(const std::string& folder) { return folder + "/table.csv"; }
inline std::string tableJsonPath(const std::string& folder) { return folder + "/table.json"; }
inline std::string fleetJsonPath(const std::string& folder) { return folder + "/fleet.json"; }
inline std::string fleetReportPath(const std::string& folder) { return folder + "/fleet.html"; }

/// The fleet report for programs: schema rubber_suspension/fleet/3: types with verdicts, effects, parameters and values
/// that are far out; parameters by rig and type. Values are logarithms of re-estimated over configured value. The same
/// bytes for the same results.
std::string toJson(const FleetFindings& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
