// Reads evidence from JSON.
#include "judge/read_evidence.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

constexpr const char* kEvidenceSchema = "rubber_suspension/evidence/11";

// JSON has no infinity, so the residual of a hypothesis that cannot be simulated is null.
double numberOf(const ordered_json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

std::vector<double> numbersOf(const ordered_json& list) {
  std::vector<double> numbers;
  std::transform(list.begin(), list.end(), std::back_inserter(numbers), numberOf);
  return numbers;
}

judge::LogEvidence logOf(const ordered_json& value) {
  return {numberOf(value.at("floor")),           numberOf(value.at("floor_uncertainty")),
          numberOf(value.at("weight")),          value.at("unseen").get<bool>(),
          value.at("blocks").get<std::size_t>(), value.at("octaves").get<std::vector<double>>()};
}

judge::HypothesisEvidence hypothesisOf(const ordered_json& value) {
  judge::HypothesisEvidence hypothesis;
  value.at("members").get_to(hypothesis.members);
  value.at("terms").get_to(hypothesis.terms);
  value.at("beyond").get_to(hypothesis.beyond);
  value.at("free_trends").get_to(hypothesis.free_in_log.trend);
  value.at("free_offsets").get_to(hypothesis.free_in_log.offset);
  value.at("free_gains").get_to(hypothesis.free_in_log.gain);
  hypothesis.idle = value.value("idle", false);
  value.at("keeps_values").get_to(hypothesis.keeps_values);
  hypothesis.chi_squared = numberOf(value.at("chi_squared"));
  hypothesis.log_errors = numbersOf(value.at("log_errors"));
  for (const ordered_json& member : value.at("sizes")) {
    hypothesis.sizes.push_back(numbersOf(member));
  }
  for (const ordered_json& log : value.at("shares")) {
    hypothesis.shares.push_back(numbersOf(log));
  }
  return hypothesis;
}

judge::Evidence evidenceOf(const ordered_json& value) {
  if (value.at("schema") != kEvidenceSchema) {
    throw std::invalid_argument(std::string("not evidence of a diagnosis: its schema is not ") + kEvidenceSchema);
  }
  judge::Evidence evidence;
  value.at("effects").get_to(evidence.effects);
  value.at("one_form").get_to(evidence.one_form);
  value.at("guess").get_to(evidence.guess);
  value.at("excluded").get_to(evidence.excluded);
  value.at("constant").get_to(evidence.constant);
  value.at("contains").get_to(evidence.contains);
  for (const ordered_json& hypothesis : value.at("hypotheses")) {
    evidence.hypotheses.push_back(hypothesisOf(hypothesis));
  }
  for (const ordered_json& log : value.at("logs")) {
    evidence.logs.push_back(logOf(log));
  }
  return evidence;
}

}  // namespace

judge::Evidence parseEvidence(const std::string& text) {
  try {
    return evidenceOf(ordered_json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("not evidence of a diagnosis: ") + error.what());
  }
}

}  // namespace rubber_suspension::diagnosis
