// The files of a plan.
#include <fmt/format.h>

#include <filesystem>

#include "diagnosis/report/json_parts.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/text.h"
#include "io/output_files.h"
#include "log/new_file.h"
#include "rubber_suspension/diagnosis/plan.h"

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

std::string logTable(const Plan& plan) {
  return table({"log", "#length [s]", "#rate [Hz]", "#largest |z|", "#largest speed", "#largest force"}, plan.logs,
               [](const PlannedLog& log) -> Row {
                 return {escape(log.log),
                         fmt::format("{:.1f}", log.duration),
                         fmt::format("{:.4g}", 1.0 / log.dt),
                         quantity(log.largest_displacement, "m"),
                         quantity(log.highest_rate, "m/s"),
                         quantity(log.largest_force, "N")};
               });
}

}  // namespace

std::string toJson(const Plan& plan) {
  ordered_json logs = ordered_json::array();
  for (const PlannedLog& log : plan.logs) {
    logs.push_back({{"log", log.log},
                    {"duration_s", log.duration},
                    {"sampling_rate_hz", 1.0 / log.dt},
                    {"largest_displacement_m", log.largest_displacement},
                    {"highest_rate_m_per_s", log.highest_rate},
                    {"largest_force_N", log.largest_force}});
  }
  const ordered_json report = {{"schema", "rubber_suspension/experiment_plan/1"},
                               {"component", plan.component},
                               {"logs", logs},
                               {"could_show", toJson(plan.could_show)},
                               {"meta", metaJson(plan.run)}};
  return report.dump(2) + "\n";
}

std::string toHtml(const Plan& plan) {
  const std::string title = "Experiment plan: " + plan.component;
  return page(title, fmt::format("<p class=kicker>{}</p>\n<h1>Of {} effects: {}.</h1>\n", escape(title),
                                 plan.could_show.implanted.size(), outcomesInNumbers(plan.could_show)) +
                         couldShowHtml(plan.could_show) + "<h2>The programmes</h2>\n" + logTable(plan) +
                         fmt::format("<p class=note>Forces are those of the component as configured. Made by:</p>\n"
                                     "<pre>{}</pre>\n",
                                     escape(plan.run.command_line)));
}

std::vector<std::string> planFiles() { return {"plan.json", "plan.html"}; }

void writePlan(const Plan& plan, const std::string& folder) {
  io::makeFolder(folder);
  log::writeNewFile((std::filesystem::path(folder) / "plan.json").string(), toJson(plan));
  log::writeNewFile((std::filesystem::path(folder) / "plan.html").string(), toHtml(plan));
}

}  // namespace rubber_suspension::diagnosis
