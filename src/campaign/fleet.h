// Computes the results of a campaign: a table in the order of the manifest, and statistics of the fleet, such as how
// often a verdict or an effect occurs and how values scatter.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/manifest.h"
#include "campaign/record.h"

namespace rubber_suspension::campaign {

/// Returns the distribution of a number over one or more components, as in fleet.json: components, median and
/// quartiles. For six or more components it also has median_interval_95, the distribution-free 95 % interval of the
/// median, whose limits are two of the values (Thompson, Ann. Math. Statist. 7 (1936) 122-128).
nlohmann::ordered_json distributionOf(std::vector<double> values);

/// Smallest logarithm of a ratio that a bench can resolve. A smaller deviation does not make a value an outlier.
constexpr double kWorthSaying = 0.02;

/// Smallest number of components among which outliers are reported.
constexpr std::size_t kFewestComponents = 6;

/// Statistics of components, which are added job by job in the order of the manifest.
class Fleet {
 public:
  /// Adds the components of diagnoses and estimates; ignores failed jobs and replays.
  void add(const Job& job, const Record& record);

  /// Returns types and rigs by name, as in fleet.json. A type has `verdicts` and named `effects`, the most frequent
  /// first, each with its share of the diagnosed components and the interval_95 of this share for Jeffreys' prior.
  /// `parameters` are the distributions of ln(re-estimated / configured value). `far_out` lists values that differ from
  /// the nearest quartile by more than four interquartile ranges, and from the median by more than kWorthSaying.
  /// `listed` are the first components. `rigs` has the same distributions for each rig, type and parameter, if a rig
  /// tested several types. A compliant rig reduces the stiffness of a stiff type more than that of a soft type, while a
  /// wrong gain scales all types alike.
  nlohmann::ordered_json analyse() const;

 private:
  struct Component {
    std::string id;  // id of the job that diagnosed it
    std::string name;
    std::string report;  // relative to the folder of the campaign; may be empty
    std::string test_rig;
    Findings findings;
  };

  static nlohmann::ordered_json describe(const std::string& type, const std::vector<Component>& components);
  nlohmann::ordered_json describeRigs() const;

  std::map<std::string, std::vector<Component>> types_;
};

struct CollectSummary {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t missing = 0;          ///< including broken records
  std::vector<std::string> broken;  ///< errors of the broken records
  std::string page_problem;         ///< reason why fleet.html could not be written; empty if it was written
};

/// Writes table.csv, table.json, fleet.json and fleet.html. Their bytes do not depend on the time, the place or the
/// order of the runs. Each job has a row, even without a result. Throws std::runtime_error.
CollectSummary collect(const Manifest& manifest, const std::string& folder);

inline std::string tableCsvPath(const std::string& folder) { return folder + "/table.csv"; }
inline std::string tableJsonPath(const std::string& folder) { return folder + "/table.json"; }
inline std::string fleetJsonPath(const std::string& folder) { return folder + "/fleet.json"; }
inline std::string fleetReportPath(const std::string& folder) { return folder + "/fleet.html"; }

/// Returns the contents of fleet.json: schema, counts of jobs, and Fleet::analyse().
std::string toJson(const Fleet& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
