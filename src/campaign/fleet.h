// Results of a campaign: a table in the order of the manifest, and statistics of the fleet, such as how often a verdict
// or an effect occurs and how values scatter.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/manifest.h"
#include "campaign/record.h"

namespace rubber_suspension::campaign {

/// Returns the distribution of a number over one or more components, as in fleet.json: components, median, quartiles,
/// and, for six or more, median_interval_95: the distribution-free 95 % interval of the median, between two of the
/// values (Thompson, Ann. Math. Statist. 7 (1936) 122-128).
nlohmann::ordered_json distributionOf(std::vector<double> values);

/// Smallest logarithm that a bench can resolve: no smaller deviation makes a value an outlier.
constexpr double kWorthSaying = 0.02;

/// Smallest number of values among which outliers are reported.
constexpr std::size_t kFewestComponents = 6;

/// Statistics of components, which are added job by job in the order of the manifest.
class Fleet {
 public:
  /// Adds the components of diagnoses and estimates; ignores failed jobs and replays.
  void add(const Job& job, const Record& record);

  /// Returns types and rigs by name, as in fleet.json. A type has `verdicts` and named `effects`, most frequent first,
  /// each with the share of the diagnosed components and its interval_95, by Jeffreys' prior; `parameters`, the
  /// distributions of logarithms of re-estimated over configured values; `far_out`, values farther from the quartiles
  /// than four times their distance, and from the median than kWorthSaying; and `listed`, its first components. `rigs`
  /// has the same distributions by rig, type and parameter for rigs with several types: a compliant rig reduces the
  /// stiffness of a stiff type more than that of a soft one, a wrong gain scales all alike.
  nlohmann::ordered_json analyse() const;

 private:
  struct Component {
    std::string id;  // id of its job
    std::string name;
    std::string report;  // path relative to the campaign's folder; may be empty
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
  std::string page_problem;         ///< reason why there is no fleet.html; empty if there is one
};

/// Writes table.csv, table.json, fleet.json and fleet.html, whose bytes do not depend on the time, place or order of
/// the runs. Jobs without a result have a row, too. Throws std::runtime_error.
CollectSummary collect(const Manifest& manifest, const std::string& folder);

inline std::string tableCsvPath(const std::string& folder) { return folder + "/table.csv"; }
inline std::string tableJsonPath(const std::string& folder) { return folder + "/table.json"; }
inline std::string fleetJsonPath(const std::string& folder) { return folder + "/fleet.json"; }
inline std::string fleetReportPath(const std::string& folder) { return folder + "/fleet.html"; }

/// Returns fleet.json: schema rubber_suspension/fleet/3, the counts of jobs and Fleet::analyse().
std::string toJson(const Fleet& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
