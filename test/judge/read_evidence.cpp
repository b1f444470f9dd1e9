// Evidence from JSON.
#include "judge/read_evidence.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

constexpr const char* kEvidenceSchema = "rubber_suspension/evidence/4";
constexpr const char* kOlderSchema = "rubber_suspension/evidence/3";

// JSON has no infinity: what a hypothesis leaves that no model run follows is null.
double numberOf(const ordered_json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

std::vector<double> numbersOf(const ordered_json& list) {
  std::vector<double> numbers;
  std::transform(list.begin(), list.end(), std::back_inserter(numbers), numberOf);
  return numbers;
}

LogEvidence logOf(const ordered_json& value) {
  return {numberOf(value.at("floor")), numberOf(value.at("floor_uncertainty")), numberOf(value.at("weight")),
          value.at("unseen").get<bool>(), value.value("blocks", std::size_t{0})};
}

HypothesisEvidence hypothesisOf(const ordered_json& value) {
  HypothesisEvidence hypothesis;
  value.at("members").get_to(hypothesis.members);
  value.at("terms").get_to(hypothesis.terms);
  value.at("free_trends").get_to(hypothesis.free_trends);
  value.at("free_gains").get_to(hypothesis.free_gains);
  hypothesis.penalty = numberOf(value.at("penalty"));
  hypothesis.log_errors = numbersOf(value.at("log_errors"));
  for (const ordered_json& member : value.at("sizes")) {
    hypothesis.sizes.push_back(numbersOf(member));
  }
  return hypothesis;
}

// Schema 3 lists the log of each block, and parts of unseen logs by hypothesis.
void countBlocks(const ordered_json& value, std::vector<LogEvidence>& logs) {
  for (const ordered_json& log : value.at("block_logs")) {
    ++logs.at(log.get<std::size_t>()).blocks;
  }
  const auto fitted = static_cast<std::size_t>(
      std::count_if(logs.begin(), logs.end(), [](const LogEvidence& log) { return !log.unseen; }));
  const ordered_json& re_estimated = value.at("hypotheses").at(Evidence::kReEstimated);
  for (const ordered_json& part :
       re_estimated.value("unseen", ordered_json{{"parts", ordered_json::array()}}).at("parts")) {
    ++logs.at(fitted + part.at(2).get<std::size_t>()).blocks;
  }
}

Evidence evidenceOf(const ordered_json& value) {
  if (value.at("schema") != kEvidenceSchema && value.at("schema") != kOlderSchema) {
    throw std::invalid_argument(std::string("not evidence of a diagnosis: its schema is not ") + kEvidenceSchema);
  }
  Evidence evidence;
  value.at("effects").get_to(evidence.effects);
  value.at("on_rig").get_to(evidence.on_rig);
  for (const ordered_json& hypothesis : value.at("hypotheses")) {
    evidence.hypotheses.push_back(hypothesisOf(hypothesis));
  }
  for (const ordered_json& log : value.at("logs")) {
    evidence.logs.push_back(logOf(log));
  }
  if (value.at("schema") == kOlderSchema) {
    countBlocks(value, evidence.logs);
  }
  return evidence;
}

}  // namespace

Evidence parseEvidence(const std::string& text) {
  try {
    return evidenceOf(ordered_json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("not evidence of a diagnosis: ") + error.what());
  } catch (const std::out_of_range&) {
    throw std::invalid_argument("not evidence of a diagnosis: a block of a log that it does not have");
  }
}

}  // namespace rubber_suspension::diagnosis
