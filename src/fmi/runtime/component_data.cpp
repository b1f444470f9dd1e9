// The component of an FMU as JSON.
#include "fmi/runtime/component_data.h"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fmi {
namespace {

using nlohmann::json;

json entriesToJson(const std::vector<element::ElementDescription>& entries) {
  json list = json::array();
  for (const element::ElementDescription& entry : entries) {
    list.push_back({{"type", entry.type}, {"values", entry.values}});
  }
  return list;
}

std::vector<element::ElementDescription> entriesFromJson(const json& list) {
  std::vector<element::ElementDescription> entries;
  for (const json& entry : list) {
    entries.push_back(
        {entry.at("type").get<std::string>(), entry.at("values").get<std::map<std::string, std::vector<double>>>()});
  }
  return entries;
}

json frameToJson(const Eigen::Isometry3d& frame) {
  return std::vector<double>(frame.matrix().data(), frame.matrix().data() + frame.matrix().size());
}

Eigen::Isometry3d frameFromJson(const json& list) {
  const auto numbers = list.get<std::array<double, 16>>();
  return Eigen::Isometry3d(Eigen::Map<const Eigen::Matrix4d>(numbers.data()));
}

json sixToJson(const ComponentData& data) {
  const component::SixDirectionsLaws& laws = *data.six;
  json six = {{"translation", laws.translation}, {"rotation", laws.rotation},    {"axis", laws.axis},
              {"measure", laws.measure},         {"valid", laws.valid_rotation}, {"on_a", frameToJson(laws.on_a)},
              {"on_b", frameToJson(laws.on_b)},  {"elements", json::array()}};
  for (const auto& elements : laws.elements) {
    six["elements"].push_back(entriesToJson(elements));
  }
  return {{"name", data.name}, {"guid", data.guid}, {"six", six}};
}

component::SixDirectionsLaws sixFromJson(const json& six) {
  component::SixDirectionsLaws laws;
  for (std::size_t i = 0; i < laws.elements.size(); ++i) {
    laws.elements[i] = entriesFromJson(six.at("elements").at(i));
  }
  six.at("translation").get_to(laws.translation);
  six.at("rotation").get_to(laws.rotation);
  six.at("axis").get_to(laws.axis);
  six.at("measure").get_to(laws.measure);
  six.at("valid").get_to(laws.valid_rotation);
  laws.on_a = frameFromJson(six.at("on_a"));
  laws.on_b = frameFromJson(six.at("on_b"));
  return laws;
}

}  // namespace

std::vector<element::ElementDescription> ComponentData::modelElements() const {
  if (model == estimation::Model::elements) {
    return elements;
  }
  std::vector<element::ElementDescription> estimated = estimation::estimate(model, specification);
  for (element::ElementDescription& entry : estimated) {
    entry = element::complete(entry);
  }
  return estimated;
}

std::vector<element::ElementDescription> ComponentData::allElements() const {
  std::vector<element::ElementDescription> all = modelElements();
  all.insert(all.end(), add.begin(), add.end());
  all.insert(all.end(), temperature.begin(), temperature.end());
  return all;
}

std::string toJson(const ComponentData& data) {
  if (data.six) {
    return sixToJson(data).dump();
  }
  json specification = json::object();
  for (const auto& [name, value] : data.specification.values()) {
    specification[name] = value;
  }
  return json({{"name", data.name},
               {"guid", data.guid},
               {"model", estimation::toString(data.model)},
               {"specification", specification},
               {"elements", entriesToJson(data.elements)},
               {"add", entriesToJson(data.add)},
               {"temperature", entriesToJson(data.temperature)}})
      .dump();
}

ComponentData fromJson(const std::string& text) {
  const json content = json::parse(text);
  ComponentData data;
  data.name = content.at("name").get<std::string>();
  data.guid = content.at("guid").get<std::string>();
  if (content.contains("six")) {
    data.six = sixFromJson(content.at("six"));
    return data;
  }
  const auto model = estimation::modelFromString(content.at("model").get<std::string>());
  if (!model) {
    throw std::invalid_argument("model: unknown");
  }
  data.model = *model;
  data.specification.describe(estimation::Describes::base);  // the whole was taken apart when the FMU was made
  for (const auto& [name, value] : content.at("specification").items()) {
    data.specification.set(name, value.get<double>());
  }
  data.elements = entriesFromJson(content.at("elements"));
  data.add = entriesFromJson(content.at("add"));
  data.temperature = entriesFromJson(content.at("temperature"));
  return data;
}

}  // namespace rubber_suspension::fmi
