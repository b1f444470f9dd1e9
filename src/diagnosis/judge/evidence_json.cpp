// Converts evidence to JSON.
#include "diagnosis/judge/evidence_json.h"

#include <nlohmann/json.hpp>

namespace rubber_suspension::diagnosis::judge {
namespace {

using nlohmann::ordered_json;

constexpr const char* kEvidenceSchema = "rubber_suspension/evidence/11";

ordered_json logJson(const LogEvidence& log) {
  return {{"floor", log.floor},   {"floor_uncertainty", log.floor_uncertainty},
          {"weight", log.weight}, {"unseen", log.unseen},
          {"blocks", log.blocks}, {"octaves", log.octaves}};
}

ordered_json hypothesisJson(const HypothesisEvidence& hypothesis) {
  return {{"members", hypothesis.members},
          {"terms", hypothesis.terms},
          {"beyond", hypothesis.beyond},
          {"free_trends", hypothesis.free_in_log.trend},
          {"free_offsets", hypothesis.free_in_log.offset},
          {"free_gains", hypothesis.free_in_log.gain || hypothesis.free_in_log.by_factor},
          {"idle", hypothesis.idle},
          {"keeps_values", hypothesis.keeps_values},
          {"chi_squared", hypothesis.chi_squared},
          {"log_errors", hypothesis.log_errors},
          {"sizes", hypothesis.sizes},
          {"shares", hypothesis.shares}};
}

}  // namespace

std::string toJson(const Evidence& evidence) {
  ordered_json hypotheses = ordered_json::array();
  for (const HypothesisEvidence& hypothesis : evidence.hypotheses) {
    hypotheses.push_back(hypothesisJson(hypothesis));
  }
  ordered_json logs = ordered_json::array();
  for (const LogEvidence& log : evidence.logs) {
    logs.push_back(logJson(log));
  }
  const ordered_json value = {{"schema", kEvidenceSchema},     {"effects", evidence.effects},
                              {"one_form", evidence.one_form}, {"guess", evidence.guess},
                              {"excluded", evidence.excluded}, {"constant", evidence.constant},
                              {"contains", evidence.contains}, {"logs", logs},
                              {"hypotheses", hypotheses}};
  return value.dump() + "\n";
}

}  // namespace rubber_suspension::diagnosis::judge
