// Writes the results of a campaign as CSV and JSON, and the statistics of its fleet.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/algorithm/string/replace.hpp>
#include <filesystem>

#include "campaign/fleet.h"
#include "campaign/record.h"
#include "element/each.h"
#include "io/page.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

std::string csvCell(const ordered_json& value) {
  if (value.is_null()) {
    return "";
  }
  std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (value.is_string() && !text.empty() && std::string("=+-@\t").find(text[0]) != std::string::npos) {
    text.insert(0, 1, '\'');  // otherwise a spreadsheet would evaluate it
  }
  const bool plain = text.find_first_of(",\"\n\r") == std::string::npos;
  return plain ? text : "\"" + boost::replace_all_copy(text, "\"", "\"\"") + "\"";
}

// The drawn numbers of the specification come before the results.
ordered_json valuesOf(const Job& job, const Record* record) {
  ordered_json values = ordered_json::object();
  for (const auto& [name, value] : job.specification) {
    values["specification." + name] = value;
  }
  if (record != nullptr && record->failed()) {
    values["error"] = record->error;
  } else if (record != nullptr) {
    values.update(record->values);
    if (const std::string report = reportPath(*record); !report.empty()) {
      values["report"] = report;
    }
  }
  return values;
}

ordered_json headOf(const Manifest& manifest, const Job& job, const Record* record) {
  const auto name_of = [&](std::size_t log) {
    return std::filesystem::path(manifest.inputs[log].path).stem().string();
  };
  return {{"id", job.id},
          {"group", job.group},
          {"type", job.type},
          {"test_piece", job.test_piece},
          {"command", toString(job.command)},
          {"component", job.component},
          {"logs", element::joined(job.logs, " ", name_of)},
          {"status", record == nullptr ? "missing" : (record->failed() ? "failed" : "done")}};
}

// Rows are stored as text, because parsed values of 10^5 jobs would not fit into memory.
void writeCsv(const std::string& path, const std::vector<std::string>& rows, const ordered_json& columns) {
  log::NewFile file(path);
  std::string header = "id,group,type,test_piece,command,component,logs,status";
  for (const auto& [name, value] : columns.items()) {
    header += "," + csvCell(name);
  }
  file.line(header);
  for (const std::string& row : rows) {
    ordered_json head = ordered_json::parse(row);
    const ordered_json values = std::move(head["values"]);
    head.erase("values");
    std::vector<std::string> cells = element::each(head, csvCell);
    for (const auto& [name, value] : columns.items()) {
      cells.push_back(csvCell(values.value(name, ordered_json())));
    }
    file.line(fmt::format("{}", fmt::join(cells, ",")));
  }
  file.commit();
}

void writeJson(const std::string& path, const std::vector<std::string>& rows) {
  log::NewFile file(path);
  file.line("{\"schema\": \"rubber_suspension/campaign_table/1\",\n\"jobs\": [");
  for (const std::string& row : rows) {
    file.line(row + (&row == &rows.back() ? "" : ","));
  }
  file.line("]}");
  file.commit();
}

}  // namespace

CollectSummary collect(const Manifest& manifest, const std::string& folder) {
  CollectSummary summary;
  ordered_json columns;  // names of all values, in the order of the manifest
  Fleet fleet;
  std::vector<std::string> rows;
  for (const Job& job : manifest.jobs) {
    const FoundRecord found = findRecord(folder, job.id, manifest.version, FileCheck::digests);
    const Record* const record = found.record ? &*found.record : nullptr;
    if (!found.problem.empty()) {
      summary.broken.push_back(found.problem);
    }
    ++(record == nullptr ? summary.missing : (record->failed() ? summary.failed : summary.done));
    ordered_json row = headOf(manifest, job, record);
    row["values"] = valuesOf(job, record);
    columns.update(row["values"]);
    rows.push_back(row.dump());
    if (record != nullptr) {
      fleet.add(job, *record);
    }
  }
  writeCsv(tableCsvPath(folder), rows, columns);
  writeJson(tableJsonPath(folder), rows);
  io::removePage(fleetReportPath(folder));
  log::writeNewFile(fleetJsonPath(folder), toJson(fleet, summary));
  summary.page_problem = io::renderPage(fleetJsonPath(folder));
  return summary;
}

}  // namespace rubber_suspension::campaign
