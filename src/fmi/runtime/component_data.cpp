// The component of an FMU as JSON.
#include "fmi/runtime/component_data.h"

#include <array>
#include <nlohmann/json.hpp>

#include "element/refuse.h"
#include "rubber_suspension/element/catalogue.h"

template <>
struct nlohmann::adl_serializer<Eigen::Isometry3d> {
  static void to_json(json& list, const Eigen::Isometry3d& frame) {
    list = std::vector<double>(frame.data(), frame.data() + frame.matrix().size());
  }
  static void from_json(const json& list, Eigen::Isometry3d& frame) {
    frame = Eigen::Isometry3d(Eigen::Map<const Eigen::Matrix4d>(list.get<std::array<double, 16>>().data()));
  }
};

namespace rubber_suspension::element {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ElementDescription, type, values)
}  // namespace rubber_suspension::element

namespace rubber_suspension::component {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SixDirectionsLaws, elements, translation, rotation, axis, measure, valid_rotation,
                                   on_a, on_b)
}  // namespace rubber_suspension::component

namespace rubber_suspension::fmi {

Elements completed(Elements entries) {
  for (element::ElementDescription& entry : entries) {
    entry = element::complete(entry);
  }
  return entries;
}

Elements ComponentData::modelElements() const {
  return model == estimation::Model::elements ? elements : completed(estimation::estimate(model, specification));
}

Elements ComponentData::allElements() const {
  Elements all = modelElements();
  all.insert(all.end(), add.begin(), add.end());
  all.insert(all.end(), temperature.begin(), temperature.end());
  return all;
}

std::string toJson(const ComponentData& data) {
  nlohmann::json content = {{"name", data.name}, {"guid", data.guid}};
  if (data.six) {
    content["six"] = *data.six;
  } else {
    content.update({{"model", estimation::toString(data.model)},
                    {"specification", data.specification.values()},
                    {"elements", data.elements},
                    {"add", data.add},
                    {"temperature", data.temperature}});
  }
  return content.dump();
}

ComponentData fromJson(const std::string& text) {
  const nlohmann::json content = nlohmann::json::parse(text);
  ComponentData data;
  content.at("name").get_to(data.name);
  content.at("guid").get_to(data.guid);
  if (content.contains("six")) {
    data.six = content.at("six").get<component::SixDirectionsLaws>();
    return data;
  }
  const auto model = estimation::modelFromString(content.at("model").get<std::string>());
  element::refuseIf(!model, "the model is unknown");
  data.model = *model;
  data.specification.describe(estimation::Describes::base);  // the exporter writes this kind of specification
  for (const auto& [name, value] : content.at("specification").items()) {
    data.specification.set(name, value.get<double>());
  }
  content.at("elements").get_to(data.elements);
  content.at("add").get_to(data.add);
  content.at("temperature").get_to(data.temperature);
  return data;
}

}  // namespace rubber_suspension::fmi
