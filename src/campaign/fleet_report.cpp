// The fleet report as HTML.
#include "campaign/fleet_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/report/text.h"
#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

constexpr std::size_t kMostRows = 500;  // of a table: more is for table.csv
constexpr std::size_t kMostDots = 500;  // of a strip of components

const char* const kStyle = R"(
:root { color-scheme: light dark; --dot: #2a78b8; --out: #c4472b; --line: #8884; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.3rem; margin-top: 2.4rem; } h3 { font-size: 1.05rem; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; }
th, td { text-align: left; padding: .25rem .6rem; border-bottom: 1px solid var(--line); vertical-align: top; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.note { opacity: .75; font-size: .92rem; }
svg { width: 16rem; height: 1.4rem; } .dot { fill: var(--dot); fill-opacity: .5; } .out { fill: var(--out); }
.axis { stroke: var(--line); } .mean { stroke: currentColor; stroke-width: 2; }
)";

using diagnosis::escape;
using diagnosis::percent;

std::string linkTo(const FleetComponent& component) {
  const std::string name = escape(component.name);
  return component.report.empty() ? name : "<a href=\"" + escape(component.report) + "\">" + name + "</a>";
}

// Of a logarithm of a ratio, "+3.2 %".
std::string change(double logarithm) { return fmt::format("{:+.1f} %", 100.0 * std::expm1(logarithm)); }

// Cells are HTML. A column whose name begins with # is of numbers, to the right.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows = {};
  std::string note = {};

  std::string html() const {
    std::string text = "<h3>" + title + "</h3>\n";
    if (rows.empty()) {
      return text + "<p>None.</p>\n";
    }
    text += "<table>" + row("th", columns);
    for (std::size_t i = 0; i < std::min(kMostRows, rows.size()); ++i) {
      text += row("td", rows[i]);
    }
    text += "</table>\n";
    if (rows.size() > kMostRows) {
      text += fmt::format("<p class=note>and {} more, in table.csv</p>\n", rows.size() - kMostRows);
    }
    return text + (note.empty() ? "" : "<p class=note>" + note + "</p>\n");
  }

 private:
  std::string row(const char* element, const std::vector<std::string>& cells) const {
    std::string text = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool number = columns[i].front() == '#';
      const std::string cell = cells[i].substr(number && &cells == &columns ? 1 : 0);
      text += fmt::format("<{}{}>{}</{}>", element, number ? " class=n" : "", cell, element);
    }
    return text + "</tr>\n";
  }
};

std::string within(const std::string& value, const std::string& low, const std::string& high) {
  return fmt::format("{}<br><span class=note>{} to {}</span>", value, low, high);
}

std::string verdictTable(const FleetType& type) {
  Table table{"Verdicts of the components alone", {"verdict", "#components"}};
  for (const auto& [verdict, count] : type.verdicts) {
    table.rows.push_back({escape(verdict), std::to_string(count)});
  }
  return type.verdicts.empty() ? "" : table.html();
}

std::string effectTable(const FleetType& type) {
  Table table{"Causes", {"cause", "#components that name it", "#of these sure of it", "#share", "#95 % interval"}};
  table.note =
      "A component is sure of its cause where its own logs leave no other in its place; the share is that among such "
      "components.";
  for (const EffectShare& share : type.effects) {
    table.rows.push_back({share.effect.empty() ? "no effect" : escape(share.effect), std::to_string(share.named),
                          std::to_string(share.sure), percent(share.share),
                          percent(share.interval[0]) + " to " + percent(share.interval[1])});
  }
  return type.effects.empty() ? "" : table.html();
}

// One dot a component, from the least to the greatest ratio; those that stand out in another colour.
std::string strip(const FleetParameter& parameter) {
  double reach = 1e-6;
  for (const Observation& one : parameter.observations) {
    reach = std::max(reach, std::abs(one.value));
  }
  const auto place = [&](double logarithm) { return 100.0 + 95.0 * logarithm / reach; };
  std::string svg =
      "<svg viewBox=\"0 0 200 16\"><line class=axis x1=0 y1=8 x2=200 y2=8 /><line class=axis x1=100 y1=0 "
      "x2=100 y2=16 />";
  const std::size_t stride = 1 + parameter.observations.size() / kMostDots;
  for (std::size_t i = 0; i < parameter.observations.size(); ++i) {
    const bool out = parameter.model && std::abs(parameter.model->robust_z[i]) > parameter.model->z_limit;
    if (out || i % stride == 0) {
      svg += fmt::format("<circle class={} cx={:.1f} cy=8 r=2.5 />", out ? "out" : "dot",
                         place(parameter.observations[i].value));
    }
  }
  if (parameter.model) {
    svg += fmt::format("<line class=mean x1={0:.1f} y1=2 x2={0:.1f} y2=14 />", place(parameter.model->mean));
  }
  return svg + fmt::format("</svg> <span class=note>&plusmn; {:.3g} %</span>", 100.0 * std::expm1(reach));
}

std::string parameterTable(const FleetType& type) {
  Table table{
      "Parameters: change against the configured value, and scatter between test pieces",
      {"parameter", "#components", "#mean change", "#scatter", "#scatter of most", "configured value", "spread"}};
  table.note =
      "Below each number its 95 % interval. Scatter is the standard deviation between components, without the error of "
      "each estimate.";
  const auto scatter = [](double logarithm) { return percent(std::expm1(logarithm)); };
  for (const FleetParameter& parameter : type.parameters) {
    std::vector<std::string> row = {escape(parameter.name), std::to_string(parameter.components.size())};
    if (parameter.model) {
      const RandomEffects& model = *parameter.model;
      row.push_back(within(change(model.mean), change(model.mean_interval[0]), change(model.mean_interval[1])));
      row.push_back(
          within(scatter(model.scatter), scatter(model.scatter_interval[0]), scatter(model.scatter_interval[1])));
      row.push_back(scatter(model.robust_scatter));
      row.emplace_back(parameter.wrong_for_all ? "is off for the type" : "holds");
    } else {
      row.insert(row.end(), {"", "", "", "too few components"});
    }
    row.push_back(strip(parameter));
    table.rows.push_back(row);
  }
  return type.parameters.empty() ? "" : table.html();
}

std::string standOutTable(const FleetType& type) {
  Table table{"Components that stand out", {"component", "parameter", "#over configured value", "#robust z"}};
  for (const StandOut& one : type.stand_outs) {
    table.rows.push_back({linkTo(type.components[one.component]), escape(one.parameter),
                          fmt::format("&times; {:.3f}", one.ratio), fmt::format("{:+.1f}", one.robust_z)});
  }
  return table.html();
}

std::string changedTable(const FleetType& type) {
  Table table{"Verdicts that the fleet changes", {"component", "by its own logs", "with the fleet", "why"}};
  for (const ChangedVerdict& one : type.changed) {
    table.rows.push_back({linkTo(type.components[one.component]), escape(one.from), "<b>" + escape(one.to) + "</b>",
                          "<span class=note>" + escape(one.reason) + "</span>"});
  }
  return table.html();
}

std::string rigTable(const std::vector<RigMean>& rigs) {
  Table table{"Rigs: mean change against the configured value",
              {"rig", "type", "parameter", "#components", "#mean change"}};
  table.note =
      "A rig that gives way takes more of a stiff type than of a soft one; a wrong gain or unit takes the same of all.";
  for (const RigMean& row : rigs) {
    table.rows.push_back({row.rig.empty() ? "of all jobs without a name of theirs" : escape(row.rig), escape(row.type),
                          escape(row.parameter), std::to_string(row.components), change(row.mean)});
  }
  return rigs.empty() ? "" : table.html();
}

std::string componentTable(const FleetType& type) {
  Table table{"All components", {"component", "verdict", "effects"}};
  for (const FleetComponent& component : type.components) {
    table.rows.push_back({linkTo(component), escape(component.verdict ? toString(*component.verdict) : ""),
                          escape(log::join(component.effects))});
  }
  return table.html();
}

}  // namespace

std::string fleetReportPath(const std::string& folder) { return folder + "/fleet.html"; }

std::string fleetHtml(const FleetFindings& fleet, const CollectSummary& summary) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
      "content=\"width=device-width\"><title>Fleet report</title><style>{}</style></head><body>\n<h1>Fleet "
      "report</h1>\n<p>{} jobs done, {} failed, {} missing; all of them in <a href=\"table.csv\">table.csv</a>.</p>\n",
      kStyle, summary.done, summary.failed, summary.missing);
  if (fleet.types.empty()) {
    html += "<p>No diagnosis and no estimate is done: there is no fleet to compare.</p>\n";
  }
  html += rigTable(fleet.rigs);
  for (const FleetType& type : fleet.types) {
    html += fmt::format("<h2>{}: {} components</h2>\n", escape(type.name), type.components.size());
    html += changedTable(type) + standOutTable(type) + effectTable(type) + parameterTable(type) + verdictTable(type) +
            componentTable(type);
  }
  return html + "</body></html>\n";
}

}  // namespace rubber_suspension::campaign
