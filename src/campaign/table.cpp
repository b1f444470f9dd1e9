// The results of a campaign as CSV and as JSON.
#include "campaign/table.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "campaign/record.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

// A row as text, because parsed values of 10^5 jobs would fill the memory.
struct Row {
  std::string status;
  std::string values;
};

// The names of all values, in an order that no order of work can change: that of the jobs of the manifest.
class Columns {
 public:
  void add(const ordered_json& values) {
    for (const auto& [name, value] : values.items()) {
      if (places_.emplace(name, names_.size()).second) {
        names_.push_back(name);
      }
    }
  }

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<std::string> names_;
};

std::string csvCell(const ordered_json& value) {
  if (value.is_null()) {
    return "";
  }
  std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (value.is_string() && !text.empty() && std::string("=+-@\t").find(text[0]) != std::string::npos) {
    text.insert(0, 1, '\'');  // or a spreadsheet would work it out
  }
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

// Drawn numbers of the specification stand before what was found.
ordered_json valuesOf(const Job& job, const Record* record) {
  ordered_json values = ordered_json::object();
  for (const auto& [name, value] : job.specification) {
    values["specification." + name] = value;
  }
  if (record == nullptr) {
    return values;
  }
  if (record->failed()) {
    values["error"] = record->error;
    return values;
  }
  values.update(record->values);
  if (const std::string report = reportPath(*record); !report.empty()) {
    values["report"] = report;
  }
  return values;
}

ordered_json headOf(const Job& job, const Manifest& manifest, const std::string& status) {
  std::string logs;
  for (const std::size_t log : job.logs) {
    logs += (logs.empty() ? "" : " ") + std::filesystem::path(manifest.inputs[log].path).stem().string();
  }
  return {{"id", job.id},
          {"group", job.group},
          {"type", job.type},
          {"test_piece", job.test_piece},
          {"command", toString(job.command)},
          {"component", job.component},
          {"logs", logs},
          {"status", status}};
}

// A file that takes its name when the last line is written.
class LineFile {
 public:
  explicit LineFile(const std::string& path)
      : path_(path), file_(path), stream_(file_.writingPath(), std::ios::binary) {}

  void line(const std::string& text) { stream_ << text << '\n'; }

  void close() {
    stream_.close();
    if (!stream_) {
      throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
    }
    file_.commit();
  }

 private:
  std::string path_;
  log::NewFile file_;
  std::ofstream stream_;
};

void writeCsv(const Manifest& manifest, const std::string& folder, const std::vector<Row>& rows,
              const std::vector<std::string>& names) {
  LineFile file(tableCsvPath(folder));
  std::string header = "id,group,type,test_piece,command,component,logs,status";
  for (const std::string& name : names) {
    header += "," + csvCell(name);
  }
  file.line(header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ordered_json values = ordered_json::parse(rows[i].values);
    std::string line;
    const ordered_json head = headOf(manifest.jobs[i], manifest, rows[i].status);
    for (const auto& [name, value] : head.items()) {
      line += (line.empty() ? "" : ",") + csvCell(value);
    }
    for (const std::string& name : names) {
      const auto value = values.find(name);
      line += "," + (value == values.end() ? "" : csvCell(*value));
    }
    file.line(line);
  }
  file.close();
}

void writeJson(const Manifest& manifest, const std::string& folder, const std::vector<Row>& rows) {
  LineFile file(tableJsonPath(folder));
  file.line("{\"schema\": \"rubber_suspension/campaign_table/1\",\n\"jobs\": [");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string head = headOf(manifest.jobs[i], manifest, rows[i].status).dump();
    file.line(fmt::format("{},\"values\":{}}}{}", head.substr(0, head.size() - 1), rows[i].values,
                          i + 1 < rows.size() ? "," : ""));
  }
  file.line("]}");
  file.close();
}

}  // namespace

std::string tableCsvPath(const std::string& folder) { return folder + "/table.csv"; }

std::string tableJsonPath(const std::string& folder) { return folder + "/table.json"; }

CollectSummary writeTables(const Manifest& manifest, const std::string& folder, const RowVisitor& visit) {
  CollectSummary summary;
  Columns columns;
  std::vector<Row> rows;
  for (const Job& job : manifest.jobs) {
    FoundRecord found = findRecord(folder, job.id, manifest.version);
    const Record* record = found.state == FoundRecord::State::good ? &found.record : nullptr;
    if (found.state == FoundRecord::State::broken) {
      summary.broken.push_back(found.problem);
    }
    std::size_t& count = record == nullptr ? summary.missing : (record->failed() ? summary.failed : summary.done);
    ++count;
    const ordered_json values = valuesOf(job, record);
    columns.add(values);
    rows.push_back({record == nullptr ? "missing" : (record->failed() ? "failed" : "done"), values.dump()});
    visit(job, record);
  }
  writeCsv(manifest, folder, rows, columns.names());
  writeJson(manifest, folder, rows);
  return summary;
}

}  // namespace rubber_suspension::campaign
