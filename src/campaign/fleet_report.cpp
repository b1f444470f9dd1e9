// The fleet report as HTML.
#include "campaign/fleet_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/report/text.h"

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

// A note where a table ends before its rows do.
std::string restNote(std::size_t rows) {
  return rows <= kMostRows ? "" : fmt::format("<p class=note>and {} more, in table.csv</p>\n", rows - kMostRows);
}

std::string verdictTable(const FleetType& type) {
  if (type.verdicts.empty()) {
    return "";
  }
  std::string rows;
  for (const auto& [verdict, count] : type.verdicts) {
    rows += fmt::format("<tr><td>{}</td><td class=n>{}</td></tr>\n", escape(verdict), count);
  }
  return "<h3>Verdicts of the components alone</h3>\n<table><tr><th>verdict</th><th class=n>components</th></tr>\n" +
         rows + "</table>\n";
}

std::string effectTable(const FleetType& type) {
  if (type.effects.empty()) {
    return "";
  }
  std::string rows;
  for (const EffectShare& share : type.effects) {
    rows += fmt::format(
        "<tr><td>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{} to {}</td></tr>\n",
        share.effect.empty() ? "no effect" : escape(share.effect), share.named, share.sure, percent(share.share),
        percent(share.interval[0]), percent(share.interval[1]));
  }
  return "<h3>Causes</h3>\n<table><tr><th>cause</th><th class=n>components that name it</th><th class=n>of these sure "
         "of it</th><th class=n>share</th><th class=n>95 % interval</th></tr>\n" +
         rows +
         "</table>\n<p class=note>A component is sure of its cause where its own logs leave no other in its place; the "
         "share is that among such components.</p>\n";
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
  if (type.parameters.empty()) {
    return "";
  }
  std::string rows;
  for (const FleetParameter& parameter : type.parameters) {
    std::string numbers = "<td class=n></td><td class=n></td><td class=n></td><td>too few components</td>";
    if (parameter.model) {
      const RandomEffects& model = *parameter.model;
      numbers = fmt::format(
          "<td class=n>{}<br><span class=note>{} to {}</span></td><td class=n>{}<br><span class=note>{} to "
          "{}</span></td><td class=n>{}</td><td>{}</td>",
          change(model.mean), change(model.mean_interval[0]), change(model.mean_interval[1]),
          percent(std::expm1(model.scatter)), percent(std::expm1(model.scatter_interval[0])),
          percent(std::expm1(model.scatter_interval[1])), percent(std::expm1(model.robust_scatter)),
          parameter.wrong_for_all ? "the configured value is off for the type" : "the configured value holds");
    }
    rows += fmt::format("<tr><td>{}</td><td class=n>{}</td>{}<td>{}</td></tr>\n", escape(parameter.name),
                        parameter.components.size(), numbers, strip(parameter));
  }
  return "<h3>Parameters: change against the configured value, and scatter between test pieces</h3>\n<table><tr><th>"
         "parameter</th><th class=n>components</th><th class=n>mean change</th><th class=n>scatter</th><th "
         "class=n>scatter of most</th><th></th><th></th></tr>\n" +
         rows +
         "</table>\n<p class=note>Below each number its 95 % interval. Scatter is the standard deviation between "
         "components, without the error of each estimate.</p>\n";
}

std::string standOutTable(const FleetType& type) {
  if (type.stand_outs.empty()) {
    return "<h3>Components that stand out</h3>\n<p>None.</p>\n";
  }
  std::string rows;
  for (std::size_t i = 0; i < std::min(kMostRows, type.stand_outs.size()); ++i) {
    const StandOut& one = type.stand_outs[i];
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=n>&times; {:.3f}</td><td class=n>{:+.1f}</td></tr>\n",
                        linkTo(type.components[one.component]), escape(one.parameter), one.ratio, one.robust_z);
  }
  return "<h3>Components that stand out</h3>\n<table><tr><th>component</th><th>parameter</th><th class=n>over "
         "configured "
         "value</th><th class=n>robust z</th></tr>\n" +
         rows + "</table>\n" + restNote(type.stand_outs.size());
}

std::string changedTable(const FleetType& type) {
  if (type.changed.empty()) {
    return "<h3>Verdicts that the fleet changes</h3>\n<p>None.</p>\n";
  }
  std::string rows;
  for (std::size_t i = 0; i < std::min(kMostRows, type.changed.size()); ++i) {
    const ChangedVerdict& one = type.changed[i];
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td><b>{}</b></td><td class=note>{}</td></tr>\n",
                        linkTo(type.components[one.component]), escape(one.from), escape(one.to), escape(one.reason));
  }
  return "<h3>Verdicts that the fleet changes</h3>\n<table><tr><th>component</th><th>by its own "
         "logs</th><th>with the fleet</th><th>why</th></tr>\n" +
         rows + "</table>\n" + restNote(type.changed.size());
}

std::string rigRow(const FleetRig& rig) {
  std::string types;
  for (const std::string& type : rig.types) {
    types += (types.empty() ? "" : ", ") + escape(type);
  }
  const RigJudgement& judgement = rig.judgement;
  const std::string compliance =
      rig.givesWay() ? fmt::format("{:.3g} m/N<br><span class=note>{:.3g} to {:.3g}</span>", judgement.compliance,
                                   judgement.compliance_interval[0], judgement.compliance_interval[1])
                     : "";
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td "
      "class=n>{}</td></tr>\n",
      rig.name.empty() ? "of all jobs without a name of theirs" : escape(rig.name), types,
      percent(judgement.probability(RigCause::none)), percent(judgement.probability(RigCause::factor)),
      percent(judgement.probability(RigCause::own)), percent(judgement.probability(RigCause::compliance)), compliance);
}

std::string rigTable(const std::vector<FleetRig>& rigs) {
  if (rigs.empty()) {
    return "";
  }
  std::string rows;
  for (const FleetRig& rig : rigs) {
    rows += rigRow(rig);
  }
  return "<h2>Rigs</h2>\n<p>How the stiffnesses of all types on a rig are off: a rig that gives way takes more of a "
         "stiff type than of a soft one. Where that is 95 % probable, values are compared without it.</p>\n<table><tr>"
         "<th>rig</th><th>types</th><th class=n>as configured</th><th class=n>one factor</th><th class=n>each its "
         "own</th><th class=n>rig gives way</th><th class=n>compliance</th></tr>\n" +
         rows + "</table>\n";
}

std::string componentTable(const FleetType& type) {
  std::string rows;
  for (std::size_t i = 0; i < std::min(kMostRows, type.components.size()); ++i) {
    const FleetComponent& component = type.components[i];
    std::string effects;
    for (const std::string& effect : component.effects) {
      effects += (effects.empty() ? "" : ", ") + effect;
    }
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", linkTo(component),
                        escape(component.verdict ? toString(*component.verdict) : ""), escape(effects));
  }
  return "<h3>All components</h3>\n<table><tr><th>component</th><th>verdict</th><th>effects</th></tr>\n" + rows +
         "</table>\n" + restNote(type.components.size());
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
