// The file in which the node keeps the states of its components.
#include "node/state_file.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "io/sha256.h"

namespace rubber_suspension::node {
namespace {

using nlohmann::json;

constexpr const char* kSchema = "rubber_suspension/state/1";
// The latest stamp that a message can have [ns]: seconds and nanoseconds of 32 bits.
constexpr std::int64_t kLatestStamp =
    std::int64_t{std::numeric_limits<std::uint32_t>::max()} * 1000000000 + std::numeric_limits<std::uint32_t>::max();

json toJson(const SavedPromotion& promotion) {
  return {{"component_file", promotion.description},
          {"sha256", io::sha256(promotion.description)},
          {"stage", toString(promotion.stage)},
          {"weight", promotion.weight},
          {"started", promotion.started},
          {"stamp_ns", promotion.stamp},
          {"displacement_m", promotion.displacement},
          {"memory", promotion.memory}};
}

// JSON keeps a finite double to the last bit: it is written with as many digits as that takes.
json toJson(const SavedState& state) {
  json elements = json::array();
  for (const element::ElementDescription& element : state.elements) {
    elements.push_back({{"type", element.type}, {"values", element.values}});
  }
  json entry = {{"component", state.component},
                {"elements", elements},
                {"started", state.started},
                {"stamp_ns", state.stamp},
                {"displacement_m", state.displacement},
                {"memory", state.memory}};
  if (state.promotion) {
    entry["promotion"] = toJson(*state.promotion);
  }
  return entry;
}

std::invalid_argument wrong(const std::string& key, const json& value, const std::string& accepted) {
  std::string shown = value.is_structured() ? value.type_name() : value.dump();
  shown = shown.size() > 60 ? shown.substr(0, 60) + "..." : shown;
  return std::invalid_argument(fmt::format("{}: {}; accepted: {}", key, shown, accepted));
}

double numberOf(const std::string& key, const json& value) {
  if (!value.is_number()) {
    throw wrong(key, value, "a number");
  }
  return value.get<double>();
}

std::vector<double> numbersOf(const std::string& key, const json& list) {
  if (!list.is_array()) {
    throw wrong(key, list, "a list of numbers");
  }
  std::vector<double> numbers;
  numbers.reserve(list.size());
  for (const json& value : list) {
    numbers.push_back(numberOf(key, value));
  }
  return numbers;
}

std::int64_t stampOf(const json& value) {
  if (!value.is_number_integer() || (value.is_number_unsigned() && value.get<std::uint64_t>() > kLatestStamp) ||
      value.get<std::int64_t>() < 0) {
    throw wrong("stamp_ns", value, fmt::format("a whole number from 0 to {}", kLatestStamp));
  }
  return value.get<std::int64_t>();
}

element::ElementDescription elementOf(const json& entry) {
  element::ElementDescription element;
  element.type = entry.at("type").get<std::string>();
  if (!entry.at("values").is_object()) {
    throw wrong("values", entry.at("values"), "a map of lists of numbers");
  }
  for (const auto& [name, values] : entry.at("values").items()) {
    element.values[name] = numbersOf(name, values);
  }
  return element;
}

bool isWeightOf(RunStage stage, double weight) {
  switch (stage) {
    case RunStage::configured:
      return false;  // no model is beside
    case RunStage::shadow:
      return weight == 0.0;
    case RunStage::promoted:
      return weight == 1.0;
    case RunStage::promoting:
    case RunStage::rolling_back:
      break;
  }
  return weight >= 0.0 && weight <= 1.0;
}

// The hash says whether the description is the one that was saved.
SavedPromotion promotionOf(const json& entry) {
  SavedPromotion promotion;
  promotion.description = entry.at("component_file").get<std::string>();
  if (entry.at("sha256") != io::sha256(promotion.description)) {
    throw wrong("promotion: sha256", entry.at("sha256"), "that of its component_file");
  }
  promotion.stage = runStageOf(entry.at("stage").get<std::string>());
  promotion.weight = numberOf("weight", entry.at("weight"));
  if (!isWeightOf(promotion.stage, promotion.weight)) {
    throw wrong("weight", entry.at("weight"), "0 in the stage shadow, 1 when promoted, from 0 to 1 in between");
  }
  promotion.started = entry.at("started").get<bool>();
  promotion.stamp = stampOf(entry.at("stamp_ns"));
  promotion.displacement = numberOf("displacement_m", entry.at("displacement_m"));
  promotion.memory = numbersOf("memory", entry.at("memory"));
  return promotion;
}

SavedState fromJson(const json& entry) {
  SavedState state;
  state.component = entry.at("component").get<std::string>();
  for (const json& element : entry.at("elements")) {
    state.elements.push_back(elementOf(element));
  }
  state.started = entry.at("started").get<bool>();
  state.stamp = stampOf(entry.at("stamp_ns"));
  state.displacement = numberOf("displacement_m", entry.at("displacement_m"));
  state.memory = numbersOf("memory", entry.at("memory"));
  if (entry.contains("promotion")) {
    state.promotion = promotionOf(entry.at("promotion"));
  }
  return state;
}

// The parser goes into brackets without bound, and what it gives ends by a call for each.
void refuseDeepNesting(const std::string& text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char character = text[i];
    if (quoted) {
      i += character == '\\' ? 1 : 0;
      quoted = character != '"';
    } else if (character == '"') {
      quoted = true;
    } else if (character == '[' || character == '{') {
      ++depth;
    } else if (character == ']' || character == '}') {
      --depth;
    }
    if (depth > kDeepestStateFile) {
      throw std::invalid_argument(fmt::format("nested deeper than {} brackets", kDeepestStateFile));
    }
  }
}

std::vector<SavedState> parse(const std::string& text) {
  refuseDeepNesting(text);
  const json document = json::parse(text);
  if (document.at("schema") != kSchema) {
    throw wrong("schema", document.at("schema"), kSchema);
  }
  std::vector<SavedState> states;
  std::set<std::string> names;
  for (const json& entry : document.at("states")) {
    states.push_back(fromJson(entry));
    if (!names.insert(states.back().component).second) {
      throw std::invalid_argument(fmt::format("component {} stands there twice", entry.at("component").dump()));
    }
  }
  return states;
}

// What a parser says may quote the text, line breaks among it.
std::string onOneLine(std::string message) {
  for (char& character : message) {
    character = character == '\n' || character == '\r' ? ' ' : character;
  }
  return message;
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
  try {
    return parse(text);
  } catch (const json::exception& error) {
    throw StateFileError(onOneLine(fmt::format("{}: no state file: {}", source, error.what())));
  } catch (const std::invalid_argument& error) {
    throw StateFileError(onOneLine(fmt::format("{}: no state file: {}", source, error.what())));
  }
}

void writeStateFile(const std::string& path, const std::vector<SavedState>& states) {
  const std::string text = stateText(states);
  if (text.size() > kLargestStateFile) {
    throw StateFileError(
        fmt::format("{}: the state takes {} bytes; accepted: at most {}", path, text.size(), kLargestStateFile));
  }
  replaceRegularFile(path, text);
}

std::vector<SavedState> readStateFile(const std::string& path) {
  return parseStates(readRegularFile(path, kLargestStateFile), path);
}

}  // namespace rubber_suspension::node
