// Reader of component files, for components of one direction and of six coupled directions.
#include "rubber_suspension/io/component_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "io/cancellation.h"
#include "io/component_words.h"
#include "io/effect_names.h"
#include "io/specification_reader.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::io {
namespace {

using element::namesOf;

component::Direction directionOf(const YAML::Node& key) { return *component::directionFromString(key.Scalar()); }

std::vector<std::string> directionNames() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    names.emplace_back(component::toString(static_cast<component::Direction>(i)));
  }
  return names;
}

Eigen::Isometry3d frameOf(const component::SixNumbers& numbers, component::RotationMeasure measure) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = numbers.head<3>();
  frame.linear() = component::rotationOf(measure, numbers.tail<3>()).toRotationMatrix();
  return frame;
}

class Loader : public SpecificationReader {
 public:
  explicit Loader(std::string source) : SpecificationReader(std::move(source), "a component file", "components") {}

  std::vector<ComponentDescription> load(const std::string& text) {
    const Entry root{parse(text), ""};
    checkMap(root, {"components"}, "a map with the key 'components'");
    const Entry components = require(root, "components", "a map of components by name");
    if (!components.node.IsMap() || components.node.size() == 0) {
      refuseContent(components, "a map of components by name");
    }
    if (components.node.size() > kMaximumComponents) {
      refuse(components, fmt::format("the file has {} components; accepted: at most {}", components.node.size(),
                                     kMaximumComponents));
    }
    checkUnique(components);
    std::vector<ComponentDescription> result;
    for (const auto& entry : components.node) {
      result.push_back(loadComponent(entry.first, entry.second));
      component_.clear();
    }
    return result;
  }

 private:
  // Returns a function that reads a key by means of a method of this class.
  template <class Method>
  auto by(Method method) {
    return [this, method](const Entry& entry, auto&... target) { return std::invoke(method, this, entry, target...); };
  }

  // Returns a function that reads one of these words and returns its index as a value of an enumeration.
  template <class Choice>
  auto oneOf(const std::vector<std::string>& words) {
    return [this, &words](const Entry& entry) { return static_cast<Choice>(loadWord(entry, words)); };
  }

  ComponentDescription loadComponent(const YAML::Node& key, const YAML::Node& node) {
    checkCancelled();
    if (!isBaseName(key.Scalar())) {
      refuse({key, "components"}, fmt::format("{} is not a name of a component; accepted: a letter, then letters, "
                                              "digits and underscores, at most {} characters",
                                              log::quoted(key.Scalar()), kMaximumNameLength));
    }
    component_ = key.Scalar();
    units_.clear();
    const Entry content{node, ""};
    requireMap(content, "a map with the key 'model', or 'directions' for a component of six directions");
    checkUnique(content);
    return content["directions"] ? loadSixDirections(key, content) : loadOneDirection(key, content);
  }

  ComponentDescription loadOneDirection(const YAML::Node& key, const Entry& entry) {
    const estimation::Model model = loadModel(entry);
    const bool listed = model == estimation::Model::elements;
    using One = ComponentDescription;
    std::vector<Key<One>> keys = {
        {"model"},
        {listed ? "elements" : "specification", {}, listed ? "a list of elements" : "a map"},
        {"add"},
        into("rig", &One::rig, by(&Loader::loadRig)),
        into("temperature", &One::temperature, by(&Loader::loadTemperature)),
        into("valid_displacement", &One::valid_displacement, by(&Loader::loadValidDisplacement)),
        into("excluded_effects", &One::excluded_effects, by(&Loader::loadExcludedEffects)),
        into("holds_fluid", &One::holds_fluid, by(&Loader::loadFlag))};
    if (listed) {
      keys.push_back({"tolerance"});
    }
    checkKeys(entry, namesOf(keys));
    const Entry base = require(entry, keys[1].name, keys[1].needed);
    One description =
        listed ? loadListed(base, entry["add"], entry["tolerance"]) : loadSpecification(base, model, entry["add"]);
    read(entry, keys, description);
    description.units = units_;
    try {
      description.makeComponent();
    } catch (const std::invalid_argument& error) {
      refuseAt(key, error.what());
    }
    return description;
  }

  // Reads the keys in the order of the table, in which each key follows the keys on which it depends.
  ComponentDescription loadSixDirections(const YAML::Node& key, const Entry& entry) {
    using Six = SixDirectionsDescription;
    const std::vector<Key<Six>> keys = {{"coupling", by(&Loader::loadCoupling)},
                                        {"rotation", by(&Loader::loadMeasure)},
                                        {"valid_rotation", by(&Loader::loadValidRotation)},
                                        {"frame", by(&Loader::loadFrames)},
                                        {"preload", by(&Loader::loadPreloads)},
                                        {"directions", by(&Loader::loadDirections)},
                                        {"temperature"},
                                        {"excluded_effects"},
                                        {"holds_fluid"},
                                        {"stiffness_by_preload", by(&Loader::loadPreloadTables)}};
    auto six = std::make_shared<Six>();
    six->arrangement.valid_rotation = component::kVectorEnd;
    read(entry, keys, *six);
    loadOfAll(entry, *six);
    const Entry preload = entry["preload"];
    for (const auto& load : preload.node) {
      if (!six->directions[directionOf(load.first)]) {
        refuse(keyOf(preload, load.first), "the direction is free; accepted: a direction listed under directions");
      }
    }
    try {
      six->makeComponent();
    } catch (const std::invalid_argument& error) {
      refuseAt(key, std::string("directions.") + error.what());
    }
    ComponentDescription description(component_, {});
    description.six = std::move(six);
    return description;
  }

  // Applies keys common to all directions, except for the temperature if a direction has its own.
  void loadOfAll(const Entry& entry, SixDirectionsDescription& six) {
    const Entry temperature = entry["temperature"];
    const Entry effects = entry["excluded_effects"];
    const Entry fluid = entry["holds_fluid"];
    const auto shift = temperature ? std::optional(loadTemperature(temperature)) : std::nullopt;
    const std::vector<std::string> excluded = effects ? loadExcludedEffects(effects) : std::vector<std::string>();
    const bool holds_fluid = fluid && loadFlag(fluid);
    for (std::optional<ComponentDescription>& direction : six.directions) {
      if (direction) {
        direction->temperature = direction->temperature ? direction->temperature : shift;
        direction->excluded_effects.insert(direction->excluded_effects.end(), excluded.begin(), excluded.end());
        direction->holds_fluid = direction->holds_fluid || holds_fluid;
      }
    }
  }

  void loadDirections(const Entry& directions, SixDirectionsDescription& six) {
    if (!directions.node.IsMap() || directions.node.size() == 0) {
      refuseContent(directions, "a map with keys from x, y, z, rx, ry, rz");
    }
    checkKeys(directions, directionNames());
    for (const auto& of_direction : directions.node) {
      const component::Direction direction = directionOf(of_direction.first);
      six.directions[direction] =
          loadDirection(of_direction.first, directions[of_direction.first.Scalar()], six.preload[direction]);
    }
  }

  ComponentDescription loadDirection(const YAML::Node& key, const Entry& entry,
                                     const std::optional<component::Preload>& preload) {
    if (!entry.node.IsMap()) {
      refuseContent(entry, "a map with the key 'model'; a direction that is not given is free");
    }
    place_ = entry.path;
    units_.clear();
    rotational_ = component::isRotation(directionOf(key));
    preload_ = preload;
    const Entry content{entry.node, ""};
    checkUnique(content);
    ComponentDescription description = loadOneDirection(key, content);
    description.name = component_ + "_" + key.Scalar();
    if (rotational_) {
      description.units.clear();  // so that rotations are shown in SI units
    }
    place_.clear();
    rotational_ = false;
    preload_.reset();
    return description;
  }

  void loadFrames(const Entry& entry, SixDirectionsDescription& six) {
    using Six = SixDirectionsDescription;
    const std::vector<Key<Six>> keys = {into("a", &Six::frame_on_a, by(&Loader::loadFrame)),
                                        into("b", &Six::frame_on_b, by(&Loader::loadFrame))};
    read(entry, keys, six, "a map with the keys a and b, one for each body");
    six.arrangement.on_a = frameOf(six.frame_on_a, six.arrangement.measure);
    six.arrangement.on_b = frameOf(six.frame_on_b, six.arrangement.measure);
  }

  // Accepts one word that is valid for translations and for rotations, or a map.
  void loadCoupling(const Entry& entry, SixDirectionsDescription& six) {
    using Laws = component::SixDirectionsLaws;
    const std::vector<Key<Laws>> keys = {
        into("translation", &Laws::translation, oneOf<component::Coupling>(kCouplings)),
        into("rotation", &Laws::rotation, oneOf<component::Coupling>(kCouplings)),
        into("axis", &Laws::axis, oneOf<std::size_t>(kAxes))};
    if (entry.node.IsMap()) {
      read(entry, keys, six.arrangement);
    } else {
      six.arrangement.translation = six.arrangement.rotation = oneOf<component::Coupling>(kCouplings)(entry);
    }
  }

  void loadMeasure(const Entry& entry, SixDirectionsDescription& six) {
    six.arrangement.measure = oneOf<component::RotationMeasure>(kMeasures)(entry);
    const bool cardan = six.arrangement.measure == component::RotationMeasure::cardan;
    six.arrangement.valid_rotation = cardan ? component::kCardanEnd : component::kVectorEnd;
  }

  void loadValidRotation(const Entry& entry, SixDirectionsDescription& six) {
    const element::Range range{0.0, six.arrangement.valid_rotation, true, false};
    six.arrangement.valid_rotation = loadNumber(entry, anyNumber("rad", range));
  }

  component::SixNumbers loadFrame(const Entry& entry) {
    checkMap(entry, {"position", "rotation"}, "a map with the keys position and rotation");
    component::SixNumbers frame = component::SixNumbers::Zero();
    if (const Entry position = entry["position"]) {
      frame.head<3>() = loadThree(position, "m");
    }
    if (const Entry rotation = entry["rotation"]) {
      frame.tail<3>() = loadThree(rotation, "rad");
    }
    return frame;
  }

  Eigen::Vector3d loadThree(const Entry& entry, const std::string& unit) {
    if (!entry.node.IsSequence() || entry.node.size() != 3) {
      refuseContent(entry, "a list of three numbers, along or about x, y, z");
    }
    const std::vector<double> values = loadNumbers(entry, anyNumber(unit));
    return {values[0], values[1], values[2]};
  }

  void loadPreloads(const Entry& entry, SixDirectionsDescription& six) {
    checkMap(entry, directionNames(), "a map with a load for each direction");
    for (const auto& load : entry.node) {
      const component::Direction direction = directionOf(load.first);
      six.preload[direction] = loadPreload(entry[load.first.Scalar()], direction);
    }
  }

  // Reads a preload, whose unit determines whether it is a force or a displacement.
  component::Preload loadPreload(const Entry& entry, component::Direction direction) {
    const bool turns = component::isRotation(direction);
    const std::string unit = entry.isText() ? log::unitOfQuantity(entry.text()) : "";
    component::Preload preload;
    try {
      log::UnitConversion(unit, turns ? "rad" : "m");
      preload.is_force = false;
    } catch (const std::invalid_argument&) {  // the unit must then be a unit of force
      preload.is_force = true;
    }
    if (unit.empty()) {
      refuseContent(entry,
                    fmt::format("text with a unit: a static {}", turns ? "moment ('20 N m') or rotation ('2 deg')"
                                                                       : "force ('2 kN') or displacement ('1 mm')"));
    }
    preload.value = loadNumber(entry, anyNumber(preload.is_force ? (turns ? "N m" : "N") : (turns ? "rad" : "m")));
    return preload;
  }

  void loadPreloadTables(const Entry& list, SixDirectionsDescription& six) {
    six.tables =
        loadMaps<component::PreloadTable>(list, [&](const Entry& table) { return loadPreloadTable(table, six); });
  }

  component::PreloadTable loadPreloadTable(const Entry& entry, const SixDirectionsDescription& six) {
    checkKeys(entry, {"direction", "by", "preload", "factor", "instantaneous"});
    const auto direction = [&](const char* key) {
      const Entry value = require(entry, key, log::join(directionNames()));
      return static_cast<component::Direction>(loadWord(value, directionNames()));
    };
    component::PreloadTable table;
    table.direction = direction("direction");
    table.by = direction("by");
    if (const Entry follows = entry["instantaneous"]; follows && loadFlag(follows)) {
      refuse(follows,
             "is true, but a stiffness that follows the motion of another direction would create energy over closed "
             "loops; accepted: false, with which the factor of the configured preload applies");
    }
    const Entry preload = require(entry, "preload", "a list of loads with units");
    table.factor = loadNumbers(require(entry, "factor", "a list with one factor for each preload"),
                               anyNumber("1", element::Range::positive()));
    if (!preload.node.IsSequence() || preload.node.size() != table.factor.size()) {
      refuseContent(preload, fmt::format("a list of {} preloads, one for each factor", table.factor.size()));
    }
    for (std::size_t i = 0; i < preload.node.size(); ++i) {
      table.preload.push_back(loadPreload(preload[i], table.by));
      if (i > 0 && !(table.preload[i].is_force == table.preload[0].is_force &&
                     table.preload[i].value > table.preload[i - 1].value)) {
        refuseContent(preload[i], "loads that are all forces or all displacements, and that increase");
      }
    }
    try {
      SixDirectionsDescription alone = six;
      alone.tables = {table};
      alone.factorOf(table.direction);
    } catch (const std::invalid_argument& error) {
      refuse(entry, error.what());
    }
    return table;
  }

  estimation::Model loadModel(const Entry& entry) const {
    const Entry model = require(entry, "model", log::join(modelNames()));
    return static_cast<estimation::Model>(loadWord(model, modelNames(), "a model"));
  }

  ComponentDescription loadListed(const Entry& list, const Entry& add, const Entry& tolerance) {
    estimation::SheetTolerance tolerances;
    if (tolerance) {
      tolerances.of_all = loadTolerance(tolerance);
    }
    std::vector<element::ElementDescription> elements = loadElements(list, nullptr, &tolerances.by_key);
    if (elements.empty()) {
      refuse(list, "the list is empty; accepted: at least one element");
    }
    ComponentDescription description(component_, std::move(elements));
    description.add = loadAdded(add, {});
    description.tolerance = std::move(tolerances);
    return description;
  }

  // Accepts one number for a symmetric range, or two numbers for the lower and the upper end.
  element::Range loadValidDisplacement(const Entry& entry) {
    if (!entry.node.IsSequence()) {
      const double reach = loadNumber(entry, anyNumber("m", element::Range::positive()));
      return element::Range::closed(-reach, reach);
    }
    if (entry.node.size() != 2) {
      refuse(entry, fmt::format("has {} entries; accepted: a length, or a list of two lengths, the lower length first",
                                entry.node.size()));
    }
    const std::vector<double> ends = loadNumbers(entry, anyNumber("m"));
    if (ends[0] >= ends[1]) {
      refuse(entry, fmt::format("{:g} m is not less than {:g} m; accepted: the lower length first", ends[0], ends[1]));
    }
    return element::Range::closed(ends[0], ends[1]);
  }

  std::vector<std::string> loadExcludedEffects(const Entry& list) const {
    std::vector<std::string> effects;
    if (!list.node.IsSequence()) {
      refuseContent(list, "a list of effects: " + log::join(effectNames()));
    }
    for (std::size_t i = 0; i < list.node.size(); ++i) {
      effects.push_back(effectNames()[loadWord(list[i], effectNames(), "an effect")]);
    }
    return effects;
  }
};

}  // namespace

std::vector<ComponentDescription> parseComponentFile(const std::string& text, const std::string& source) {
  return Loader(source).load(text);
}

std::vector<ComponentDescription> loadComponentFile(const std::string& path) {
  std::string text;
  try {
    text = log::readFile(path, kMaximumComponentFileSize);
  } catch (const std::runtime_error& error) {
    throw ComponentFileError(fmt::format("{}: {}", path, error.what()));
  }
  return parseComponentFile(text, path);
}

}  // namespace rubber_suspension::io
