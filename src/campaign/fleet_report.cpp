// The fleet report as JSON and as HTML.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/fleet.h"
#include "diagnosis/report/page.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

using diagnosis::words::escape;
using diagnosis::words::percent;
using diagnosis::words::Row;
using element::each;
using nlohmann::ordered_json;

constexpr std::size_t kMostRows = 500;  // of a table: more is for table.csv

ordered_json shareJson(const Share& one) {
  return {{"name", one.name}, {"components", one.components}, {"share", one.share}, {"interval_95", one.interval}};
}

ordered_json withDistribution(ordered_json json, const Distribution& distribution) {
  json["components"] = distribution.components;
  json["median"] = distribution.median;
  json["quartiles"] = distribution.quartiles;
  if (distribution.median_interval) {
    json["median_interval_95"] = *distribution.median_interval;
  }
  return json;
}

ordered_json parameterJson(const FleetParameter& parameter) {
  return withDistribution({{"name", parameter.parameter}}, parameter.distribution);
}

ordered_json rigJson(const FleetParameter& row) {
  return withDistribution({{"name", row.rig}, {"type", row.type}, {"parameter", row.parameter}}, row.distribution);
}

ordered_json typeJson(const FleetType& type) {
  const auto far_out = [&](const ComponentValue& one) -> ordered_json {
    const FleetComponent& component = type.components[one.component];
    return {{"component", component.name}, {"id", component.id}, {"parameter", one.parameter}, {"value", one.value}};
  };
  return {{"name", type.name},
          {"components", type.components.size()},
          {"verdicts", each(type.verdicts, shareJson)},
          {"effects", each(type.effects, shareJson)},
          {"parameters", each(type.parameters, parameterJson)},
          {"far_out", each(type.far_out, far_out)}};
}

// Cells are HTML; a title that begins with # is of numbers. Nothing without rows.
std::string section(const std::string& title, const Row& titles, std::vector<Row> rows, const std::string& note = "") {
  if (rows.empty()) {
    return "";
  }
  const std::size_t all = rows.size();
  rows.resize(std::min(kMostRows, all));
  const std::string rest = rows.size() < all ? fmt::format("and {} more, in table.csv. ", all - rows.size()) : "";
  return "<h3>" + title + "</h3>\n" + diagnosis::words::table(titles, rows) + "<p class=note>" + rest + note + "</p>\n";
}

std::string linkTo(const FleetComponent& component) {
  const std::string name = escape(component.name);
  return component.report.empty() ? name : "<a href=\"" + escape(component.report) + "\">" + name + "</a>";
}

// Of a logarithm of a ratio, "+3.2 %".
std::string change(double logarithm) { return fmt::format("{:+.1f} %", 100.0 * std::expm1(logarithm)); }

std::string shareTable(const std::string& title, const std::string& name, const std::vector<Share>& shares) {
  const auto row = [](const Share& share) -> Row {
    return {escape(share.name), std::to_string(share.components), percent(share.share),
            percent(share.interval[0]) + " to " + percent(share.interval[1])};
  };
  return section(title, {name, "#components", "#share", "#95 % interval"}, each(shares, row),
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
  const auto row = [](const FleetParameter& parameter) {
    return cellsOf(parameter.distribution, {escape(parameter.parameter)});
  };
  return section("Parameters: change against the configured value",
                 {"parameter", "#components", "#median", "#95 % interval", "#quartiles"}, each(type.parameters, row),
                 "The quartiles contain scatter between test pieces and the error of each estimate.");
}

std::string farOutTable(const FleetType& type) {
  const auto row = [&](const ComponentValue& one) -> Row {
    return {linkTo(type.components[one.component]), escape(one.parameter), change(one.value)};
  };
  return section("Components that are far out", {"component", "parameter", "#change"}, each(type.far_out, row),
                 "Farther from the quartiles than four times their distance.");
}

std::string rigTable(const std::vector<FleetParameter>& rigs) {
  const auto row = [](const FleetParameter& one) {
    const std::string rig = one.rig.empty() ? "of all jobs without a name of theirs" : escape(one.rig);
    return cellsOf(one.distribution, {rig, escape(one.type), escape(one.parameter)});
  };
  return section("Rigs: change against the configured value",
                 {"rig", "type", "parameter", "#components", "#median", "#95 % interval", "#quartiles"},
                 each(rigs, row),
                 "A rig that gives way takes more of a stiff type than of a soft one; a wrong gain or unit takes the "
                 "same of all.");
}

std::string componentTable(const FleetType& type) {
  const auto row = [](const FleetComponent& component) -> Row {
    const auto& [verdict, effects, changes] = component.findings;
    return {linkTo(component), escape(verdict ? toString(*verdict) : ""), escape(log::join(effects))};
  };
  return section("All components", {"component", "verdict", "effects"}, each(type.components, row));
}

}  // namespace

std::string toJson(const FleetFindings& fleet) {
  const ordered_json json = {{"schema", "rubber_suspension/fleet/3"},
                             {"types", each(fleet.types, typeJson)},
                             {"rigs", each(fleet.rigs, rigJson)}};
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
  return diagnosis::report::page("Fleet report", html);
}

}  // namespace rubber_suspension::campaign
