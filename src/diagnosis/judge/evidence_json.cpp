// Evidence to JSON and back.
#include "diagnosis/judge/evidence_json.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

constexpr const char* kEvidenceSchema = "rubber_suspension/evidence/3";

// JSON has no infinity: what a hypothesis leaves that no model run follows is null.
double numberOf(const ordered_json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

ordered_json partsJson(const std::vector<gap::PartError>& parts) {
  ordered_json list = ordered_json::array();
  for (const gap::PartError& part : parts) {
    list.push_back({part.error, part.weight, part.log});
  }
  return list;
}

ordered_json unseenJson(const UnseenErrors& unseen) {
  return {{"gap", unseen.gap}, {"noise_floor", unseen.noise_floor}, {"parts", partsJson(unseen.parts)}};
}

UnseenErrors unseenOf(const ordered_json& value) {
  UnseenErrors unseen;
  unseen.gap = numberOf(value.at("gap"));
  unseen.noise_floor = numberOf(value.at("noise_floor"));
  for (const ordered_json& part : value.at("parts")) {
    unseen.parts.push_back({numberOf(part.at(0)), numberOf(part.at(1)), part.at(2).get<int>()});
  }
  return unseen;
}

ordered_json logJson(const LogEvidence& log) {
  return {{"floor", log.floor},
          {"floor_uncertainty", log.floor_uncertainty},
          {"weight", log.weight},
          {"unseen", log.unseen}};
}

LogEvidence logOf(const ordered_json& value) {
  return {numberOf(value.at("floor")), numberOf(value.at("floor_uncertainty")), numberOf(value.at("weight")),
          value.at("unseen").get<bool>()};
}

std::vector<double> numbersOf(const ordered_json& list) {
  std::vector<double> numbers;
  std::transform(list.begin(), list.end(), std::back_inserter(numbers), numberOf);
  return numbers;
}

ordered_json hypothesisJson(const HypothesisEvidence& hypothesis) {
  ordered_json value = {{"members", hypothesis.members},
                        {"terms", hypothesis.terms},
                        {"free_trends", hypothesis.free_trends},
                        {"free_gains", hypothesis.free_gains},
                        {"history", hypothesis.history},
                        {"sensor", hypothesis.sensor},
                        {"last_resort", hypothesis.last_resort},
                        {"like_parameters", hypothesis.like_parameters},
                        {"within_tolerance", hypothesis.within_tolerance},
                        {"held_out", hypothesis.held_out},
                        {"penalty", hypothesis.penalty},
                        {"largest_change", hypothesis.largest_change},
                        {"block_errors", hypothesis.block_errors},
                        {"log_errors", hypothesis.log_errors},
                        {"sizes", hypothesis.sizes}};
  if (hypothesis.unseen) {
    value["unseen"] = unseenJson(*hypothesis.unseen);
  }
  return value;
}

HypothesisEvidence hypothesisOf(const ordered_json& value) {
  HypothesisEvidence hypothesis;
  value.at("members").get_to(hypothesis.members);
  value.at("terms").get_to(hypothesis.terms);
  value.at("free_trends").get_to(hypothesis.free_trends);
  hypothesis.free_gains = value.value("free_gains", false);
  hypothesis.history = value.value("history", false);
  hypothesis.sensor = value.value("sensor", false);
  value.at("last_resort").get_to(hypothesis.last_resort);
  hypothesis.like_parameters = value.value("like_parameters", false);
  hypothesis.within_tolerance = value.value("within_tolerance", false);
  hypothesis.held_out = numberOf(value.at("held_out"));
  hypothesis.penalty = numberOf(value.at("penalty"));
  hypothesis.largest_change = numberOf(value.at("largest_change"));
  hypothesis.block_errors = numbersOf(value.at("block_errors"));
  hypothesis.log_errors = numbersOf(value.at("log_errors"));
  for (const ordered_json& member : value.at("sizes")) {
    hypothesis.sizes.push_back(numbersOf(member));
  }
  if (value.contains("unseen")) {
    hypothesis.unseen = unseenOf(value.at("unseen"));
  }
  return hypothesis;
}

NamedEvidence evidenceOf(const ordered_json& value) {
  if (value.at("schema") != kEvidenceSchema) {
    throw std::invalid_argument(std::string("not evidence of a diagnosis: its schema is not ") + kEvidenceSchema);
  }
  NamedEvidence named;
  Evidence& evidence = named.evidence;
  value.at("effects").get_to(named.effects);
  value.at("on_rig").get_to(named.on_rig);
  for (const ordered_json& hypothesis : value.at("hypotheses")) {
    evidence.hypotheses.push_back(hypothesisOf(hypothesis));
  }
  for (const ordered_json& log : value.at("logs")) {
    evidence.logs.push_back(logOf(log));
  }
  value.at("block_logs").get_to(evidence.block_logs);
  value.at("block_weights").get_to(evidence.block_weights);
  value.at("testable").get_to(evidence.testable);
  value.at("contains").get_to(evidence.contains);
  evidence.element_level = numberOf(value.at("element_level"));
  evidence.noise_floor = numberOf(value.at("noise_floor"));
  evidence.slow_noise = numberOf(value.at("slow_noise"));
  evidence.discretisation = numberOf(value.at("discretisation"));
  evidence.caused_by_motion = value.value("caused_by_motion", 1.0);
  value.at("has_unseen_logs").get_to(evidence.has_unseen_logs);
  value.at("resamplings").get_to(evidence.resamplings);
  value.at("seed").get_to(evidence.seed);
  return named;
}

}  // namespace

std::string toJson(const NamedEvidence& named) {
  const Evidence& evidence = named.evidence;
  ordered_json hypotheses = ordered_json::array();
  for (const HypothesisEvidence& hypothesis : evidence.hypotheses) {
    hypotheses.push_back(hypothesisJson(hypothesis));
  }
  ordered_json logs = ordered_json::array();
  for (const LogEvidence& log : evidence.logs) {
    logs.push_back(logJson(log));
  }
  const ordered_json value = {{"schema", kEvidenceSchema},
                              {"effects", named.effects},
                              {"on_rig", named.on_rig},
                              {"noise_floor", evidence.noise_floor},
                              {"slow_noise", evidence.slow_noise},
                              {"discretisation", evidence.discretisation},
                              {"caused_by_motion", evidence.caused_by_motion},
                              {"element_level", evidence.element_level},
                              {"has_unseen_logs", evidence.has_unseen_logs},
                              {"resamplings", evidence.resamplings},
                              {"seed", evidence.seed},
                              {"testable", evidence.testable},
                              {"contains", evidence.contains},
                              {"logs", logs},
                              {"block_logs", evidence.block_logs},
                              {"block_weights", evidence.block_weights},
                              {"hypotheses", hypotheses}};
  return value.dump() + "\n";
}

NamedEvidence parseEvidence(const std::string& text) {
  try {
    return evidenceOf(ordered_json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("not evidence of a diagnosis: ") + error.what());
  }
}

}  // namespace rubber_suspension::diagnosis
