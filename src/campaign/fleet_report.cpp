// The fleet report as JSON and as HTML.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/collect.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/text.h"
#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

using diagnosis::escape;
using diagnosis::percent;
using nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kMostRows = 500;  // of a table: more is for table.csv

ordered_json sharesJson(const std::vector<Share>& shares) {
  ordered_json list = ordered_json::array();
  for (const auto& [name, components, share, interval] : shares) {
    list.push_back({{"name", name}, {"components", components}, {"share", share}, {"interval_95", interval}});
  }
  return list;
}

void addDistribution(ordered_json& json, const Distribution& distribution) {
  json["components"] = distribution.components;
  json["median"] = distribution.median;
  json["quartiles"] = distribution.quartiles;
  if (distribution.median_interval) {
    json["median_interval_95"] = *distribution.median_interval;
  }
}

ordered_json typeJson(const FleetType& type) {
  ordered_json parameters = ordered_json::array();
  ordered_json far_out = ordered_json::array();
  for (const FleetParameter& parameter : type.parameters) {
    parameters.push_back({{"name", parameter.name}});
    addDistribution(parameters.back(), parameter.distribution);
    for (const ComponentValue& one : parameter.far_out) {
      const FleetComponent& component = type.components[one.component];
      far_out.push_back(
          {{"component", component.name}, {"id", component.id}, {"parameter", parameter.name}, {"value", one.value}});
    }
  }
  return {{"name", type.name},
          {"components", type.components.size()},
          {"verdicts", sharesJson(type.verdicts)},
          {"effects", sharesJson(type.effects)},
          {"parameters", parameters},
          {"far_out", far_out}};
}

// Cells are HTML; a title that begins with # is of numbers. Nothing without rows.
std::string section(const std::string& title, const std::vector<std::string>& titles, const Rows& rows,
                    const std::string& note = "") {
  if (rows.empty()) {
    return "";
  }
  const std::size_t shown = std::min(kMostRows, rows.size());
  const std::string rest = shown < rows.size() ? fmt::format("and {} more, in table.csv. ", rows.size() - shown) : "";
  return "<h3>" + title + "</h3>\n" +
         diagnosis::table(titles, Rows(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(shown))) +
         "<p class=note>" + rest + note + "</p>\n";
}

std::string linkTo(const FleetComponent& component) {
  const std::string name = escape(component.name);
  return component.report.empty() ? name : "<a href=\"" + escape(component.report) + "\">" + name + "</a>";
}

// Of a logarithm of a ratio, "+3.2 %".
std::string change(double logarithm) { return fmt::format("{:+.1f} %", 100.0 * std::expm1(logarithm)); }

std::string shareTable(const std::string& title, const std::string& name, const std::vector<Share>& shares) {
  Rows rows;
  for (const Share& share : shares) {
    rows.push_back({escape(share.name), std::to_string(share.components), percent(share.share),
                    percent(share.interval[0]) + " to " + percent(share.interval[1])});
  }
  return section(title, {name, "#components", "#share", "#95 % interval"}, rows,
                 "Shares are those of the components with a diagnosis.");
}

// The cells before it, then number of components, median, its interval and quartiles.
std::vector<std::string> cellsOf(const Distribution& distribution, std::vector<std::string> cells) {
  const auto range = [](const std::array<double, 2>& ends) { return change(ends[0]) + " to " + change(ends[1]); };
  cells.push_back(std::to_string(distribution.components));
  cells.push_back(change(distribution.median));
  cells.push_back(distribution.median_interval ? range(*distribution.median_interval) : "");
  cells.push_back(range(distribution.quartiles));
  return cells;
}

std::string parameterTable(const FleetType& type) {
  Rows rows;
  for (const FleetParameter& parameter : type.parameters) {
    rows.push_back(cellsOf(parameter.distribution, {escape(parameter.name)}));
  }
  return section("Parameters: change against the configured value",
                 {"parameter", "#components", "#median", "#95 % interval", "#quartiles"}, rows,
                 "The quartiles contain scatter between test pieces and the error of each estimate.");
}

std::string farOutTable(const FleetType& type) {
  Rows rows;
  for (const FleetParameter& parameter : type.parameters) {
    for (const ComponentValue& one : parameter.far_out) {
      rows.push_back({linkTo(type.components[one.component]), escape(parameter.name), change(one.value)});
    }
  }
  return section("Components that are far out", {"component", "parameter", "#change"}, rows,
                 "Farther from the quartiles than four times their distance.");
}

std::string rigTable(const std::vector<RigParameter>& rigs) {
  Rows rows;
  for (const RigParameter& row : rigs) {
    const std::string rig = row.rig.empty() ? "of all jobs without a name of theirs" : escape(row.rig);
    rows.push_back(cellsOf(row.distribution, {rig, escape(row.type), escape(row.parameter)}));
  }
  return section("Rigs: change against the configured value",
                 {"rig", "type", "parameter", "#components", "#median", "#95 % interval", "#quartiles"}, rows,
                 "A rig that gives way takes more of a stiff type than of a soft one; a wrong gain or unit takes the "
                 "same of all.");
}

std::string componentTable(const FleetType& type) {
  Rows rows;
  for (const FleetComponent& component : type.components) {
    const auto& [verdict, effects, changes] = component.findings;
    rows.push_back({linkTo(component), escape(verdict ? toString(*verdict) : ""), escape(log::join(effects))});
  }
  return section("All components", {"component", "verdict", "effects"}, rows);
}

}  // namespace

std::string fleetJsonPath(const std::string& folder) { return folder + "/fleet.json"; }

std::string fleetReportPath(const std::string& folder) { return folder + "/fleet.html"; }

std::string toJson(const FleetFindings& fleet) {
  ordered_json types = ordered_json::array();
  for (const FleetType& type : fleet.types) {
    types.push_back(typeJson(type));
  }
  ordered_json rigs = ordered_json::array();
  for (const RigParameter& row : fleet.rigs) {
    rigs.push_back({{"name", row.rig}, {"type", row.type}, {"parameter", row.parameter}});
    addDistribution(rigs.back(), row.distribution);
  }
  const ordered_json json = {{"schema", "rubber_suspension/fleet/3"}, {"types", types}, {"rigs", rigs}};
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string fleetHtml(const FleetFindings& fleet, const CollectSummary& summary) {
  std::string html = fmt::format(
      "<h1>Fleet report</h1>\n<p>{} jobs done, {} failed, {} missing; all of them in <a "
      "href=\"table.csv\">table.csv</a>.</p>\n",
      summary.done, summary.failed, summary.missing);
  if (fleet.types.empty()) {
    html += "<p>No diagnosis and no estimate is done: there is no fleet to compare.</p>\n";
  }
  html += rigTable(fleet.rigs);
  for (const FleetType& type : fleet.types) {
    html += fmt::format("<h2>{}: {} components</h2>\n", escape(type.name), type.components.size()) +
            shareTable("Effects", "effect", type.effects) + farOutTable(type) + parameterTable(type) +
            shareTable("Verdicts", "verdict", type.verdicts) + componentTable(type);
  }
  return diagnosis::page("Fleet report", html);
}

}  // namespace rubber_suspension::campaign
