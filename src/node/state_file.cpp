// The file in which the node stores the states of its components.
#include "node/state_file.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "element/refuse.h"
#include "io/sha256.h"
#include "log/text.h"

namespace rubber_suspension::node {
namespace {

using nlohmann::json;

constexpr const char* kSchema = "rubber_suspension/state/1";
// The latest stamp that a message can have [ns]: seconds and nanoseconds are numbers of 32 bits.
constexpr std::int64_t kLatestStamp =
    std::int64_t{std::numeric_limits<std::uint32_t>::max()} * 1000000000 + std::numeric_limits<std::uint32_t>::max();

// JSON preserves a finite double to the last bit, because it is written with as many digits as needed.
json streamJson(const SavedStream& stream) {
  return {{"started", stream.started},
          {"stamp_ns", stream.stamp},
          {"displacement_m", stream.displacement},
          {"memory", stream.memory}};
}

json toJson(const SavedState& state) {
  json entry = streamJson(state);
  entry["component"] = state.component;
  entry["elements"] = json::array();
  for (const element::ElementDescription& element : state.model.elements) {
    entry["elements"].push_back({{"type", element.type}, {"values", element.values}});
    if (element.of_rig) {
      entry["elements"].back()["of_rig"] = true;
    }
  }
  if (!state.model.sha256.empty()) {
    entry["model_sha256"] = state.model.sha256;
  }
  if (state.promotion) {
    entry["promotion"] = streamJson(*state.promotion);
    entry["promotion"].update({{"component_file", state.promotion->description},
                               {"sha256", io::sha256(state.promotion->description)},
                               {"stage", toString(state.promotion->stage)},
                               {"weight", state.promotion->weight}});
  }
  return entry;
}

std::invalid_argument wrong(const std::string& key, const json& value, const std::string& accepted) {
  std::string shown = value.is_structured() ? value.type_name() : value.dump();
  shown = shown.size() > 60 ? shown.substr(0, 60) + "..." : shown;
  return std::invalid_argument(fmt::format("{}: {}; accepted: {}", key, shown, accepted));
}

template <class Value>
Value valueOf(const std::string& key, const json& value, const std::string& accepted) {
  try {
    return value.get<Value>();
  } catch (const json::type_error&) {
    throw wrong(key, value, accepted);
  }
}

std::int64_t stampOf(const json& value) {
  if (!value.is_number_integer() || (value.is_number_unsigned() && value.get<std::uint64_t>() > kLatestStamp) ||
      value.get<std::int64_t>() < 0) {
    throw wrong("stamp_ns", value, fmt::format("a whole number from 0 to {}", kLatestStamp));
  }
  return value.get<std::int64_t>();
}

SavedStream streamOf(const json& entry) {
  return {entry.at("started").get<bool>(), stampOf(entry.at("stamp_ns")),
          valueOf<double>("displacement_m", entry.at("displacement_m"), "a number"),
          valueOf<std::vector<double>>("memory", entry.at("memory"), "a list of numbers")};
}

element::ElementDescription elementOf(const json& entry) {
  element::ElementDescription element;
  element.type = entry.at("type").get<std::string>();
  for (const auto& [name, values] : entry.at("values").get_ref<const json::object_t&>()) {
    element.values[name] = valueOf<std::vector<double>>(name, values, "a list of numbers");
  }
  element.of_rig = entry.contains("of_rig") && valueOf<bool>("of_rig", entry.at("of_rig"), "true or false");
  return element;
}

bool isWeightOf(RunStage stage, double weight) {
  const double least = stage == RunStage::promoted ? 1.0 : 0.0;
  const double most = stage == RunStage::shadow ? 0.0 : 1.0;
  return stage != RunStage::configured && weight >= least && weight <= most;  // `configured` has no second model
}

// Returns the saved second model. A hash shows whether its description was changed after saving.
SavedPromotion promotionOf(const json& entry) {
  SavedPromotion promotion{streamOf(entry), entry.at("component_file").get<std::string>(),
                           runStageOf(entry.at("stage").get<std::string>()),
                           valueOf<double>("weight", entry.at("weight"), "a number")};
  if (entry.at("sha256") != io::sha256(promotion.description)) {
    throw wrong("promotion: sha256", entry.at("sha256"), "the SHA-256 digest of its component_file");
  }
  if (!isWeightOf(promotion.stage, promotion.weight)) {
    throw wrong("weight", entry.at("weight"), "0 in the stage shadow, 1 when promoted, from 0 to 1 in between");
  }
  return promotion;
}

SavedState stateOf(const json& entry) {
  SavedState state{streamOf(entry), entry.at("component").get<std::string>(), {}, {}};
  for (const json& element : entry.at("elements")) {
    state.model.elements.push_back(elementOf(element));
  }
  if (entry.contains("model_sha256")) {
    state.model.sha256 = entry.at("model_sha256").get<std::string>();
  }
  if (entry.contains("promotion")) {
    state.promotion = promotionOf(entry.at("promotion"));
  }
  return state;
}

// Throws for deep nesting, because parser and destructor of the JSON library recurse for each bracket without a limit.
bool refuseDeepNesting(int depth, json::parse_event_t /*event*/, const json& /*parsed*/) {
  element::refuseIf(depth >= kDeepestStateFile, "nested deeper than {} brackets", kDeepestStateFile);
  return true;
}

std::vector<SavedState> parse(const std::string& text) {
  const json document = json::parse(text, refuseDeepNesting);
  if (document.at("schema") != kSchema) {
    throw wrong("schema", document.at("schema"), kSchema);
  }
  std::vector<SavedState> states;
  std::set<std::string> names;
  for (const json& entry : document.at("states")) {
    states.push_back(stateOf(entry));
    if (!names.insert(states.back().component).second) {
      throw std::invalid_argument(fmt::format("component {} is given twice", entry.at("component").dump()));
    }
  }
  return states;
}

}  // namespace

std::string stateText(const std::vector<SavedState>& states) {
  json document = {{"schema", kSchema}, {"states", json::array()}};
  for (const SavedState& state : states) {
    document["states"].push_back(toJson(state));
  }
  return document.dump(1) + "\n";
}

std::vector<SavedState> parseStates(const std::string& text, const std::string& source) {
  // The message of the parser may quote text with line breaks.
  const auto refusal = [&](const std::exception& error) {
    return FileError(log::oneLine(fmt::format("{}: the file is not a state file: {}", source, error.what())));
  };
  try {
    return parse(text);
  } catch (const json::exception& error) {
    throw refusal(error);
  } catch (const std::invalid_argument& error) {
    throw refusal(error);
  }
}

void writeStateFile(const std::string& path, const std::vector<SavedState>& states) {
  const std::string text = stateText(states);
  element::refuseIf<FileError>(text.size() > kLargestStateFile, "{}: the state has {} bytes; accepted: at most {}",
                               path, text.size(), kLargestStateFile);
  replaceRegularFile(path, text);
}

std::vector<SavedState> readStateFile(const std::string& path) {
  return parseStates(readRegularFile(path, kLargestStateFile), path);
}

}  // namespace rubber_suspension::node
