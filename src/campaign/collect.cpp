// What is left of a campaign at its end.
#include "campaign/collect.h"

#include "campaign/fleet_report.h"
#include "campaign/record.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {

CollectSummary collect(const Manifest& manifest, const std::string& folder) {
  Fleet fleet;
  CollectSummary summary = writeTables(manifest, folder, [&](const Job& job, const Record* record) {
    if (record != nullptr) {
      try {
        fleet.add(job, *record);
      } catch (const std::exception& error) {
        throw std::runtime_error(recordPath(folder, job.id) + ": " + error.what());
      }
    }
  });
  const FleetFindings findings = fleet.analyse();
  log::writeNewFile(fleetJsonPath(folder), toJson(findings));
  log::writeNewFile(fleetReportPath(folder), fleetHtml(findings, summary));
  return summary;
}

}  // namespace rubber_suspension::campaign
