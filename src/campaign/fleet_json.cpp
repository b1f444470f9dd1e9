// What a fleet says, for programs.
#include <nlohmann/json.hpp>

#include "campaign/fleet_report.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

ordered_json parameterJson(const FleetParameter& parameter) {
  ordered_json json = {{"name", parameter.name}, {"components", parameter.components.size()}};
  if (parameter.model) {
    const RandomEffects& model = *parameter.model;
    json["mean"] = model.mean;
    json["mean_interval_95"] = model.mean_interval;
    json["scatter"] = model.scatter;
    json["scatter_interval_95"] = model.scatter_interval;
    json["scatter_of_most"] = model.robust_scatter;
    json["wrong_for_all"] = parameter.wrong_for_all;
  }
  return json;
}

ordered_json typeJson(const FleetType& type) {
  ordered_json json = {{"name", type.name},
                       {"components", type.components.size()},
                       {"verdicts", type.verdicts},
                       {"causes", ordered_json::array()},
                       {"parameters", ordered_json::array()},
                       {"stand_out", ordered_json::array()},
                       {"changed", ordered_json::array()}};
  for (const EffectShare& share : type.effects) {
    json["causes"].push_back({{"effect", share.effect},
                              {"named", share.named},
                              {"sure", share.sure},
                              {"share", share.share},
                              {"interval_95", share.interval}});
  }
  for (const FleetParameter& parameter : type.parameters) {
    json["parameters"].push_back(parameterJson(parameter));
  }
  for (const StandOut& one : type.stand_outs) {
    json["stand_out"].push_back({{"component", type.components[one.component].name},
                                 {"id", type.components[one.component].id},
                                 {"parameter", one.parameter},
                                 {"ratio", one.ratio},
                                 {"robust_z", one.robust_z}});
  }
  for (const ChangedVerdict& one : type.changed) {
    json["changed"].push_back({{"component", type.components[one.component].name},
                               {"id", type.components[one.component].id},
                               {"from", one.from},
                               {"to", one.to},
                               {"reason", one.reason}});
  }
  return json;
}

ordered_json rigJson(const RigMean& row) {
  return {{"name", row.rig},
          {"type", row.type},
          {"parameter", row.parameter},
          {"components", row.components},
          {"mean", row.mean}};
}

}  // namespace

std::string fleetJsonPath(const std::string& folder) { return folder + "/fleet.json"; }

std::string toJson(const FleetFindings& fleet) {
  ordered_json json = {
      {"schema", "rubber_suspension/fleet/2"}, {"types", ordered_json::array()}, {"rigs", ordered_json::array()}};
  for (const FleetType& type : fleet.types) {
    json["types"].push_back(typeJson(type));
  }
  for (const RigMean& row : fleet.rigs) {
    json["rigs"].push_back(rigJson(row));
  }
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rubber_suspension::campaign
