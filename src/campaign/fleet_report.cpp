// The fleet report as JSON.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "campaign/fleet.h"
#include "element/each.h"

namespace rubber_suspension::campaign {
namespace {

using element::each;
using nlohmann::ordered_json;

constexpr std::size_t kMostListed = 500;  // components of a type: table.csv has all

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

ordered_json componentJson(const FleetComponent& component) {
  const auto& [verdict, effects, changes] = component.findings;
  return {{"component", component.name},
          {"report", component.report},
          {"verdict", verdict ? toString(*verdict) : ""},
          {"effects", effects}};
}

ordered_json typeJson(const FleetType& type) {
  const auto far_out = [&](const ComponentValue& one) -> ordered_json {
    const FleetComponent& component = type.components[one.component];
    return {{"component", component.name},
            {"id", component.id},
            {"report", component.report},
            {"parameter", one.parameter},
            {"value", one.value}};
  };
  const auto first = type.components.begin();
  const auto most = static_cast<std::ptrdiff_t>(std::min(kMostListed, type.components.size()));
  return {{"name", type.name},
          {"components", type.components.size()},
          {"verdicts", each(type.verdicts, shareJson)},
          {"effects", each(type.effects, shareJson)},
          {"parameters", each(type.parameters, parameterJson)},
          {"far_out", each(type.far_out, far_out)},
          {"listed", each(std::vector<FleetComponent>(first, first + most), componentJson)}};
}

}  // namespace

std::string toJson(const FleetFindings& fleet, const CollectSummary& summary) {
  const ordered_json json = {
      {"schema", "rubber_suspension/fleet/3"},
      {"jobs", {{"done", summary.done}, {"failed", summary.failed}, {"missing", summary.missing}}},
      {"types", each(fleet.types, typeJson)},
      {"rigs", each(fleet.rigs, rigJson)}};
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rubber_suspension::campaign
