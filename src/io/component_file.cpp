// The component file: a strict loader, driven by the tables of laws and models, and the writer.
#include "rubber_suspension/io/component_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "element/largest_number.h"
#include "element/suggestion.h"
#include "io/cancellation.h"
#include "io/effect_names.h"
#include "io/rotational_unit.h"
#include "io/yaml_bounds.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::io {

std::string rotationalUnit(const std::string& unit) {
  static const std::map<std::string, std::string> units = {
      {"m", "rad"},     {"N", "N m"},           {"N/m", "N m/rad"},    {"N s/m", "N m s/rad"},
      {"m/s", "rad/s"}, {"N/s", "N m/s"},       {"1/m", "1/rad"},      {"N/m^2", "N m/rad^2"},
      {"kg", "kg m^2"}, {"N/m^3", "N m/rad^3"}, {"N/m^5", "N m/rad^5"}};
  const auto found = units.find(unit);
  return found == units.end() ? unit : found->second;
}

namespace {

constexpr std::size_t kMaximumNameLength = 100;

using element::namesOf;

std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (int i = static_cast<int>(estimation::Model::kelvin_voigt); i <= static_cast<int>(estimation::Model::elements);
       ++i) {
    names.push_back(estimation::toString(static_cast<estimation::Model>(i)));
  }
  return names;
}

std::string accepted(const element::ParameterInfo& parameter) {
  const element::Range& range = parameter.range;
  const bool bounded = std::isfinite(range.lower) || std::isfinite(range.upper);
  const std::string number = bounded ? "a number " + element::describe(range) : element::describe(range);
  if (parameter.unit == "1") {
    return number + (range.upper <= 1.0 ? ", or in %" : "");
  }
  return fmt::format("{}, in {}, or text with such a unit", number, parameter.unit);
}

// The limits in the unit that the user wrote; that is one of the parameter's dimension.
std::string acceptedIn(const std::string& unit, const element::ParameterInfo& parameter) {
  if (unit.empty()) {
    return accepted(parameter);
  }
  const log::UnitConversion to_written(parameter.unit, unit);
  element::Range range = parameter.range;
  range.lower = to_written(range.lower);
  range.upper = to_written(range.upper);
  return element::describe(range) + " " + unit;
}

// A comma between digits divides a flow map there, so that what follows it stands as a key.
std::string decimalCommaHint(const std::string& key) {
  const bool digits = !key.empty() && key.find_first_not_of("0123456789eE+-") == std::string::npos;
  return digits ? " (a decimal comma before it? write a decimal point)" : "";
}

// The first line up to that one which is indented with a tab, from 0; -1 without one.
int lineWithTab(const std::string& text, int last) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= last && std::getline(lines, line); ++i) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line[first] != '#' && line.substr(0, first).find('\t') != std::string::npos) {
      return i;
    }
  }
  return -1;
}

bool isBaseName(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= kMaximumNameLength && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

std::string kindOf(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return log::quoted(node.Scalar());
    case YAML::NodeType::Sequence:
      return node.size() == 0 ? "an empty list" : "a list";
    case YAML::NodeType::Map:
      return node.size() == 0 ? "an empty map" : "a map";
    default:
      return "nothing";
  }
}

std::string hintOf(const YAML::Node& node, const std::vector<std::string>& names) {
  return node.IsScalar() ? element::didYouMean(node.Scalar(), names) : "";
}

// How the key `temperature` calls a law.
struct ShiftLaw {
  std::string name;
  std::string type;
};

const std::vector<ShiftLaw>& shiftLaws() {
  static const std::vector<ShiftLaw> laws = {{"wlf", "wlf_shift"}, {"arrhenius", "arrhenius_shift"}};
  return laws;
}

const std::vector<std::string> kCouplings = {"rectangular", "cylindrical", "spherical"};
const std::vector<std::string> kMeasures = {"vector", "cardan"};
const std::vector<std::string> kAxes = {"x", "y", "z"};

constexpr const char* kVertical = "vertical";
constexpr const char* kMerge = "<<";
constexpr const char* kGuess = "guess";

bool startsAsNumber(const std::string& text) {
  return !text.empty() && std::string("+-.0123456789").find(text[0]) != std::string::npos;
}

// A node of the file and where in its component it stands: "specification.loss_angle", "add[0].type".
struct Entry {
  YAML::Node node;
  std::string path;

  explicit operator bool() const { return node.IsDefined(); }
  bool isText() const { return node.IsScalar(); }
  const std::string& text() const { return node.Scalar(); }

  // Of a map, which may not have it.
  Entry operator[](const std::string& key) const {
    const std::string shown = isBaseName(key) ? key : log::quoted(key);
    return {node[key], path.empty() ? shown : path + "." + shown};
  }

  // Of a list.
  Entry operator[](std::size_t i) const { return {node[i], fmt::format("{}[{}]", path, i)}; }
};

class Loader;

// A key of a map, and how its value goes into what the map describes; without that it is read elsewhere. `needed`: what
// is accepted, of a key that may not be missing.
template <class Target>
struct Key {
  std::string name;
  std::function<void(Loader&, const Entry&, Target&)> read = {};
  const char* needed = nullptr;
};

// A key whose value, as `load` finds it, becomes a member.
template <class Target, class Value, class Load>
Key<Target> into(std::string name, Value Target::*member, Load load, const char* needed = nullptr) {
  return {
      std::move(name),
      [=](Loader& loader, const Entry& entry, Target& target) { target.*member = std::invoke(load, loader, entry); },
      needed};
}

// One file while it is read.
class Loader {
 public:
  explicit Loader(std::string source) : source_(std::move(source)) {}

  std::vector<ComponentDescription> load(const std::string& text) {
    const Entry root{parse(text), ""};
    checkMap(root, {"components"}, "a map with the key 'components'");
    const Entry components = require(root, "components", "a map of components by name");
    if (!components.node.IsMap() || components.node.size() == 0) {
      refuseContent(components, "a map of components by name");
    }
    if (components.node.size() > kMaximumComponents) {
      refuse(components,
             fmt::format("{} components; accepted: at most {}", components.node.size(), kMaximumComponents));
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
  [[noreturn]] void refuseLine(int line, const std::string& path, const std::string& problem) const {
    const std::string place = place_ + (place_.empty() || path.empty() ? "" : ".") + path;
    throw ComponentFileError(fmt::format("{}:{}: {}{}{}{}", source_, line,
                                         component_.empty() ? "" : fmt::format("component '{}': ", component_), place,
                                         place.empty() ? "" : ": ", problem));
  }

  [[noreturn]] void refuse(const Entry& entry, const std::string& problem) const {
    const auto key_line = entry.node.IsNull() ? lines_of_nothing_.find(entry.node.Mark().pos) : lines_of_nothing_.end();
    const int line = key_line == lines_of_nothing_.end() ? entry.node.Mark().line : key_line->second;
    refuseLine(std::max(line + 1, 1), entry.path, problem);
  }

  // A problem that says itself where it is.
  [[noreturn]] void refuseAt(const YAML::Node& node, const std::string& problem) const { refuse({node, ""}, problem); }

  // By what stands there.
  [[noreturn]] void refuseContent(const Entry& entry, const std::string& accepted) const {
    refuse(entry, kindOf(entry.node) + "; accepted: " + accepted);
  }

  // A word that is none of these names.
  [[noreturn]] void refuseWord(const Entry& entry, const std::string& wanted,
                               const std::vector<std::string>& names) const {
    refuse(entry, fmt::format("{} is not {}{}; accepted: {}", kindOf(entry.node), wanted, hintOf(entry.node, names),
                              log::join(names)));
  }

  void requireMap(const Entry& entry, const std::string& accepted = "a map") const {
    if (!entry.node.IsMap()) {
      refuseContent(entry, accepted);
    }
  }

  YAML::Node parse(const std::string& text) const {
    if (text.size() > kMaximumComponentFileSize) {
      refuseLine(1, "", fmt::format("{} bytes; accepted: at most {}", text.size(), kMaximumComponentFileSize));
    }
    const std::size_t zero = text.find('\0');
    if (zero != std::string::npos) {
      refuseLine(1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n')),
                 "", "holds a 0 byte; accepted: text in UTF-8");
    }
    try {
      if (const auto problem = beyondYamlBounds(text)) {
        refuseLine(problem->line, "", problem->text);
      }
      const YAML::Node document = YAML::Load(text);
      if (document.IsNull()) {
        refuseLine(1, "", "the file is empty; accepted: a map with the key 'components'");
      }
      if (const auto line = lineOfSecondDocument(text)) {
        refuseLine(*line, "", "a second YAML document; accepted: one");
      }
      return document;
    } catch (const YAML::Exception& error) {
      if (const int line = lineWithTab(text, error.mark.line); line >= 0) {
        refuseLine(line + 1, "", "not YAML: indented with a tab; accepted: indentation by blanks alone");
      }
      refuseLine(std::max(error.mark.line + 1, 1), "",
                 fmt::format("not YAML: {}; accepted: a component file", error.msg));
    }
  }

  void checkUnique(const Entry& map) {
    std::set<std::string> seen;
    for (const auto& entry : map.node) {
      if (entry.second.IsNull()) {
        lines_of_nothing_[entry.second.Mark().pos] = entry.first.Mark().line;
      }
      if (!entry.first.IsScalar()) {
        refuse({entry.first, map.path}, fmt::format("{} as a key; accepted: a name", kindOf(entry.first)));
      }
      if (!seen.insert(entry.first.Scalar()).second) {
        refuse(keyOf(map, entry.first), "stands twice; accepted: once");
      }
    }
    merge(map, 0);
  }

  // A merge key of YAML, `<<: *anchor` or a list of such: the keys of those maps that the map itself does not have.
  void merge(const Entry& map, int depth) const {
    constexpr int kDeepest = 10;
    const Entry sources = map[kMerge];
    if (!sources) {
      return;
    }
    YAML::Node merged = map.node;
    const bool list = sources.node.IsSequence();
    for (std::size_t i = 0; i < (list ? sources.node.size() : 1); ++i) {
      const Entry source{list ? sources.node[i] : sources.node, sources.path};
      if (!source.node.IsMap() || source.node.is(merged) || depth == kDeepest) {
        refuseContent(source, "an anchor of another map, or a list of such");
      }
      merge({source.node, map.path}, depth + 1);
      for (const auto& entry : source.node) {
        if (entry.first.IsScalar() && !map[entry.first.Scalar()]) {
          merged[entry.first.Scalar()] = entry.second;
        }
      }
    }
    merged.remove(kMerge);
  }

  void checkKeys(const Entry& map, const std::vector<std::string>& names) {
    checkUnique(map);
    for (const auto& entry : map.node) {
      const std::string& key = entry.first.Scalar();
      if (std::find(names.begin(), names.end(), key) == names.end()) {
        const std::string hint = element::didYouMean(key, names);
        refuse(keyOf(map, entry.first), fmt::format("unknown key{}; accepted: {}",
                                                    hint.empty() ? decimalCommaHint(key) : hint, log::join(names)));
      }
    }
  }

  void checkMap(const Entry& map, const std::vector<std::string>& names, const std::string& accepted = "a map") {
    requireMap(map, accepted);
    checkKeys(map, names);
  }

  // A key with the path of what it names.
  static Entry keyOf(const Entry& map, const YAML::Node& key) { return {key, map[key.Scalar()].path}; }

  Entry require(const Entry& map, const std::string& key, const std::string& what) const {
    Entry entry = map[key];
    if (!entry) {
      refuseAt(map.node, fmt::format("{} is missing; accepted: {}", entry.path, what));
    }
    return entry;
  }

  // A map by its keys, in their order.
  template <class Target>
  void read(const Entry& map, const std::vector<Key<Target>>& keys, Target& target, const char* accepted = "a map") {
    requireMap(map, accepted);
    checkKeys(map, namesOf(keys));
    for (const Key<Target>& key : keys) {
      const Entry value = key.needed == nullptr ? map[key.name] : require(map, key.name, key.needed);
      if (value && key.read) {
        key.read(*this, value, target);
      }
    }
  }

  // The direction that a key of a map names, which was checked.
  static component::Direction directionOf(const YAML::Node& key) {
    return *component::directionFromString(key.Scalar());
  }

  // Loads a row of the specification: a number, a list of numbers, or one of some words as its place.
  static auto as(const char* row) {
    return [row](Loader& loader, const Entry& entry) {
      return loader.loadNumber(entry, *element::findParameter(estimation::specificationParameters(), row));
    };
  }
  static auto numbersIn(const char* unit) {
    return [unit](Loader& loader, const Entry& entry) { return loader.loadNumbers(entry, anyNumber(unit)); };
  }
  template <class Choice>
  static auto oneOf(const std::vector<std::string>& words) {
    return [&words](Loader& loader, const Entry& entry) { return static_cast<Choice>(loader.loadWord(entry, words)); };
  }

  ComponentDescription loadComponent(const YAML::Node& key, const YAML::Node& node) {
    checkCancelled();
    if (!isBaseName(key.Scalar())) {
      refuse(
          {key, "components"},
          fmt::format("{} is not a name of a component; accepted: a letter, then letters, digits and underscores, at "
                      "most {} in all",
                      log::quoted(key.Scalar()), kMaximumNameLength));
    }
    component_ = key.Scalar();
    units_.clear();
    const Entry content{node, ""};
    requireMap(content, "a map with the key 'model', or 'directions' for six of them");
    checkUnique(content);
    return content["directions"] ? loadSixDirections(key, content) : loadOneDirection(key, content);
  }

  ComponentDescription loadOneDirection(const YAML::Node& key, const Entry& entry) {
    const estimation::Model model = loadModel(entry);
    const bool listed = model == estimation::Model::elements;
    using One = ComponentDescription;
    const std::vector<Key<One>> keys = {
        {"model"},
        {listed ? "elements" : "specification", {}, listed ? "a list of elements" : "a map"},
        {"add"},
        into("rig", &One::rig, &Loader::loadRig),
        into("temperature", &One::temperature, &Loader::loadTemperature),
        into("valid_displacement", &One::valid_displacement, &Loader::loadValidDisplacement),
        into("excluded_effects", &One::excluded_effects, &Loader::loadExcludedEffects),
        into("holds_fluid", &One::holds_fluid, &Loader::loadFlag)};
    checkKeys(entry, namesOf(keys));
    const Entry base = require(entry, keys[1].name, keys[1].needed);
    One description = listed ? loadListed(base, entry["add"]) : loadSpecification(base, model, entry["add"]);
    read(entry, keys, description);
    description.units = units_;
    try {
      description.makeComponent();
    } catch (const std::invalid_argument& error) {
      refuseAt(key, error.what());
    }
    return description;
  }

  // Each key after those that it needs.
  ComponentDescription loadSixDirections(const YAML::Node& key, const Entry& entry) {
    using Six = SixDirectionsDescription;
    static const std::vector<Key<Six>> keys = {{"coupling", &Loader::loadCoupling},
                                               {"rotation", &Loader::loadMeasure},
                                               {"valid_rotation", &Loader::loadValidRotation},
                                               {"frame", &Loader::loadFrames},
                                               {"preload", &Loader::loadPreloads},
                                               {"directions", &Loader::loadDirections},
                                               {"temperature"},
                                               {"excluded_effects"},
                                               {"holds_fluid"},
                                               {"stiffness_by_preload", &Loader::loadPreloadTables}};
    auto six = std::make_shared<Six>();
    six->arrangement.valid_rotation = component::kVectorEnd;
    read(entry, keys, *six);
    loadOfAll(entry, *six);
    const Entry preload = entry["preload"];
    for (const auto& load : preload.node) {
      if (!six->directions[directionOf(load.first)]) {
        refuse(keyOf(preload, load.first), "the direction is free; accepted: one of directions");
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

  // Keys common to all directions, beside those of each.
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
      refuseContent(directions, "a map of x, y, z, rx, ry, rz");
    }
    checkKeys(directions, directionNames());
    for (const auto& of_direction : directions.node) {
      const component::Direction direction = directionOf(of_direction.first);
      six.directions[direction] =
          loadDirection(of_direction.first, directions[of_direction.first.Scalar()], six.preload[direction]);
    }
  }

  static std::vector<std::string> directionNames() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < component::kDirections; ++i) {
      names.emplace_back(component::toString(static_cast<component::Direction>(i)));
    }
    return names;
  }

  ComponentDescription loadDirection(const YAML::Node& key, const Entry& entry,
                                     const std::optional<component::Preload>& preload) {
    if (!entry.node.IsMap()) {
      refuseContent(entry, "a map with the key 'model'; a direction that is left out is free");
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
      description.units.clear();  // whoever takes it for a component of one direction shows SI units
    }
    place_.clear();
    rotational_ = false;
    preload_.reset();
    return description;
  }

  void loadFrames(const Entry& entry, SixDirectionsDescription& six) {
    using Six = SixDirectionsDescription;
    static const std::vector<Key<Six>> keys = {into("a", &Six::frame_on_a, &Loader::loadFrame),
                                               into("b", &Six::frame_on_b, &Loader::loadFrame)};
    read(entry, keys, six, "a map with the keys a and b, the bodies");
    six.arrangement.on_a = frameOf(six.frame_on_a, six.arrangement.measure);
    six.arrangement.on_b = frameOf(six.frame_on_b, six.arrangement.measure);
  }

  // One word for translations and rotations alike, or a map.
  void loadCoupling(const Entry& entry, SixDirectionsDescription& six) {
    using Laws = component::SixDirectionsLaws;
    static const std::vector<Key<Laws>> keys = {
        into("translation", &Laws::translation, oneOf<component::Coupling>(kCouplings)),
        into("rotation", &Laws::rotation, oneOf<component::Coupling>(kCouplings)),
        into("axis", &Laws::axis, oneOf<std::size_t>(kAxes))};
    if (entry.node.IsMap()) {
      read(entry, keys, six.arrangement);
    } else {
      six.arrangement.translation = six.arrangement.rotation = oneOf<component::Coupling>(kCouplings)(*this, entry);
    }
  }

  void loadMeasure(const Entry& entry, SixDirectionsDescription& six) {
    six.arrangement.measure = oneOf<component::RotationMeasure>(kMeasures)(*this, entry);
    const bool cardan = six.arrangement.measure == component::RotationMeasure::cardan;
    six.arrangement.valid_rotation = cardan ? component::kCardanEnd : component::kVectorEnd;
  }

  void loadValidRotation(const Entry& entry, SixDirectionsDescription& six) {
    const element::Range range{0.0, six.arrangement.valid_rotation, true, false};
    six.arrangement.valid_rotation = loadNumber(entry, anyNumber("rad", range));
  }

  static Eigen::Isometry3d frameOf(const component::SixNumbers& numbers, component::RotationMeasure measure) {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translation() = numbers.head<3>();
    frame.linear() = component::rotationOf(measure, numbers.tail<3>()).toRotationMatrix();
    return frame;
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
      refuseContent(entry, "a list of three, along or about x, y, z");
    }
    const std::vector<double> values = loadNumbers(entry, anyNumber(unit));
    return {values[0], values[1], values[2]};
  }

  // A number of this unit, or a list of such, without a row in a table.
  static element::ParameterInfo anyNumber(const std::string& unit, element::Range range = element::Range::any()) {
    return {"", unit, element::Role::choice, range, "", {}, true};
  }

  void loadPreloads(const Entry& entry, SixDirectionsDescription& six) {
    checkMap(entry, directionNames(), "a map of a load by direction");
    for (const auto& load : entry.node) {
      const component::Direction direction = directionOf(load.first);
      six.preload[direction] = loadPreload(entry[load.first.Scalar()], direction);
    }
  }

  // A force or a displacement, as its unit tells.
  component::Preload loadPreload(const Entry& entry, component::Direction direction) {
    const bool turns = component::isRotation(direction);
    const std::string unit = entry.isText() ? log::unitOfQuantity(entry.text()) : "";
    component::Preload preload;
    try {
      log::UnitConversion(unit, turns ? "rad" : "m");
      preload.is_force = false;
    } catch (const std::invalid_argument&) {  // then it has to be a force
      preload.is_force = true;
    }
    if (unit.empty()) {
      refuseContent(entry,
                    fmt::format("text with a unit, a static {}", turns ? "moment ('20 N m') or rotation ('2 deg')"
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
             "true: a stiffness that follows another direction's motion does work over closed loops; accepted: false, "
             "the factor at the configured preload");
    }
    const Entry preload = require(entry, "preload", "a list of loads with units");
    table.factor =
        loadNumbers(require(entry, "factor", "a list of as many factors"), anyNumber("1", element::Range::positive()));
    if (!preload.node.IsSequence() || preload.node.size() != table.factor.size()) {
      refuseContent(preload, fmt::format("a list of {}, as many as factors", table.factor.size()));
    }
    for (std::size_t i = 0; i < preload.node.size(); ++i) {
      table.preload.push_back(loadPreload(preload[i], table.by));
      if (i > 0 && !(table.preload[i].is_force == table.preload[0].is_force &&
                     table.preload[i].value > table.preload[i - 1].value)) {
        refuseContent(preload[i], "loads of one kind that increase");
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
    const std::optional<estimation::Model> found =
        model.isText() ? estimation::modelFromString(model.text()) : std::nullopt;
    if (!found) {
      refuseWord(model, "a model", modelNames());
    }
    return *found;
  }

  ComponentDescription loadListed(const Entry& list, const Entry& add) {
    std::vector<element::ElementDescription> elements = loadElements(list);
    if (elements.empty()) {
      refuse(list, "an empty list; accepted: at least one element");
    }
    ComponentDescription description(component_, std::move(elements));
    description.add = loadAdded(add, {});
    return description;
  }

  std::vector<element::ElementDescription> loadAdded(const Entry& add, const estimation::Specification& specification) {
    return add ? loadElements(add, &specification) : std::vector<element::ElementDescription>{};
  }

  RigTolerances loadRig(const Entry& entry) {
    checkMap(entry, namesOf(rigToleranceTable()));
    RigTolerances tolerances;
    for (const RigToleranceInfo& row : rigToleranceTable()) {
      if (const Entry value = entry[row.name]) {
        tolerances.*row.member = loadTolerance(value, row.name);
      }
    }
    return tolerances;
  }

  const ShiftLaw& loadShift(const Entry& entry) const {
    const auto& laws = shiftLaws();
    const Entry shift = require(entry, "shift", log::join(namesOf(laws)));
    const auto found = std::find_if(laws.begin(), laws.end(),
                                    [&](const ShiftLaw& law) { return shift.isText() && shift.text() == law.name; });
    if (found == laws.end()) {
      refuseWord(shift, "a law of temperature", namesOf(laws));
    }
    return *found;
  }

  element::ElementDescription loadTemperature(const Entry& entry) {
    requireMap(entry, "a map with the key 'shift'");
    checkUnique(entry);
    const ShiftLaw& law = loadShift(entry);
    const std::vector<element::ParameterInfo>& table = element::findElementType(law.type)->parameters;
    std::vector<std::string> keys = namesOf(table);
    keys.insert(keys.begin(), "shift");
    checkKeys(entry, keys);
    element::ElementDescription description{law.type, {}};
    for (element::ParameterInfo parameter : table) {
      if (parameter.name == "activation_energy") {
        parameter.range = element::Range::openBelow(0.0, parameter.range.upper);
      }
      if (parameter.name != kVertical) {
        description.values[parameter.name] = {
            loadNumber(require(entry, parameter.name, accepted(parameter)), parameter)};
      } else if (const Entry value = entry[kVertical]) {
        description.values[kVertical] = {loadVertical(value, parameter, description.value("reference"))};
      }
    }
    return description;
  }

  // One number for both sides, or the two ends.
  element::Range loadValidDisplacement(const Entry& entry) {
    if (!entry.node.IsSequence()) {
      const double reach = loadNumber(entry, anyNumber("m", element::Range::positive()));
      return element::Range::closed(-reach, reach);
    }
    if (entry.node.size() != 2) {
      refuse(entry,
             fmt::format("{} entries; accepted: a length, or a list of two, the lower one first", entry.node.size()));
    }
    const std::vector<double> ends = loadNumbers(entry, anyNumber("m"));
    if (ends[0] >= ends[1]) {
      refuse(entry, fmt::format("from {:g} m to {:g} m; accepted: the lower one first", ends[0], ends[1]));
    }
    return element::Range::closed(ends[0], ends[1]);
  }

  std::vector<std::string> loadExcludedEffects(const Entry& list) const {
    std::vector<std::string> effects;
    if (!list.node.IsSequence()) {
      refuseContent(list, "a list of effects: " + log::join(effectNames()));
    }
    for (std::size_t i = 0; i < list.node.size(); ++i) {
      const Entry effect = list[i];
      const std::vector<std::string>& names = effectNames();
      if (!effect.isText() || std::find(names.begin(), names.end(), effect.text()) == names.end()) {
        refuseWord(effect, "an effect", names);
      }
      effects.push_back(effect.text());
    }
    return effects;
  }

  // The reference stands before in the tables.
  double loadVertical(const Entry& entry, const element::ParameterInfo& parameter, double reference) {
    if (entry.isText() && entry.text() == "proportional") {
      return 1.0 / (reference + element::kZeroCelsius);
    }
    if (entry.isText() && entry.text() == "none") {
      return 0.0;
    }
    if (!entry.isText() || !startsAsNumber(entry.text())) {
      refuse(entry, fmt::format("{} is not a vertical shift{}; accepted: proportional (b_T = T/T_0), none, or {}",
                                kindOf(entry.node), hintOf(entry.node, {"proportional", "none"}), accepted(parameter)));
    }
    return loadNumber(entry, parameter);
  }

  RigTolerance loadTolerance(const Entry& entry, const std::string& key) const {
    if (!entry.isText()) {
      refuse(entry, fmt::format("{} is not a number; accepted: a number or text", kindOf(entry.node)));
    }
    try {
      return parseRigTolerance(key, entry.text());
    } catch (const std::invalid_argument& error) {
      refuseAt(entry.node, fmt::format("rig.{}", error.what()));
    }
  }

  ComponentDescription loadSpecification(const Entry& entry, estimation::Model model, const Entry& add) {
    requireMap(entry);
    estimation::Specification specification =
        loadValues(entry, {"describes", "tolerance", "static_curve", "scale_with", "points", "preloads"});
    loadDescribed(entry, specification);
    preloadSpecification(entry, specification);
    const bool fitted = !specification.points().empty() || !specification.preloads().empty();
    for (const std::string& key : estimation::modelInfo(model).required) {
      const char* of_curve = model == estimation::Model::kelvin_voigt ? "dynamic_stiffness" : "static_stiffness";
      if (!fitted && !(specification.curve() != nullptr && key == of_curve)) {
        require(entry, key, accepted(here(*element::findParameter(estimation::specificationParameters(), key))));
      }
    }
    std::vector<element::ElementDescription> added = loadAdded(add, specification);
    try {
      return {component_, model, std::move(specification), std::move(added)};
    } catch (const std::invalid_argument& error) {
      refuseSpecification(entry, error.what());
    }
  }

  // The preload of a direction is where its numbers hold on its static curve; without one they hold everywhere.
  void preloadSpecification(const Entry& entry, estimation::Specification& specification) const {
    if (!preload_) {
      return;
    }
    const std::string own = preload_->is_force ? "nominal_force" : "nominal_displacement";
    for (const char* key : {"nominal_force", "nominal_displacement"}) {
      if (const auto given = specification.find(key); given && !(key == own && *given == preload_->value)) {
        refuse(entry[key], "given beside another preload of the direction; accepted: one of both");
      }
    }
    if (specification.curve() != nullptr) {
      specification.set(own, preload_->value);
    }
  }

  // The numbers of a specification, beside which there may be others.
  estimation::Specification loadValues(const Entry& entry, const std::vector<std::string>& others) {
    const std::vector<element::ParameterInfo>& table = estimation::specificationParameters();
    std::vector<std::string> keys = namesOf(table);
    keys.insert(keys.end(), others.begin(), others.end());
    checkKeys(entry, keys);
    estimation::Specification specification;
    estimation::Specification::Units units;
    for (const element::ParameterInfo& row : table) {
      const element::ParameterInfo parameter = here(row);
      if (rotational_) {
        units[parameter.name] = {parameter.unit, 1.0};
      }
      const Entry value = entry[parameter.name];
      if (!value) {
        continue;
      }
      specification.set(parameter.name, loadNumber(value, parameter));
      if (const std::string unit = log::unitOfQuantity(value.text()); !unit.empty()) {
        units[parameter.name] = {unit, log::UnitConversion(unit, parameter.unit)(1.0)};
      }
    }
    specification.writeIn(std::move(units));
    return specification;
  }

  // The words that a specification has beside numbers.
  void loadDescribed(const Entry& entry, estimation::Specification& specification) {
    if (const Entry describes = entry["describes"]) {
      specification.describe(loadWord(describes, {"component", "base"}) == 0 ? estimation::Describes::component
                                                                             : estimation::Describes::base);
    }
    if (const Entry curve = entry["static_curve"]) {
      specification.setCurve(loadCurve(curve, entry["scale_with"]));
    } else if (const Entry scale = entry["scale_with"]) {
      refuse(scale, "given without static_curve; accepted: both");
    }
    if (const Entry points = entry["points"]) {
      specification.setPoints(
          loadMaps<estimation::SpecifiedPoint>(points, [&](const Entry& point) { return loadPoint(point); }));
    }
    if (const Entry preloads = entry["preloads"]) {
      specification.setPreloads(loadMaps<estimation::Specification::Values>(
          preloads, [&](const Entry& block) { return loadValues(block, {}).values(); }));
    }
    if (const Entry tolerance = entry["tolerance"]) {
      specification.setTolerance(loadSheetTolerance(tolerance, specification));
    }
  }

  // Of all numbers of a sheet, or of each by its key. Points and preloads have numbers of their own.
  estimation::SheetTolerance loadSheetTolerance(const Entry& entry, const estimation::Specification& specification) {
    if (!entry.node.IsMap()) {
      return {loadSheetShare(entry)};
    }
    std::vector<std::string> keys = namesOf(estimation::specificationParameters());
    keys.erase(std::remove_if(keys.begin(), keys.end(),
                              [&](const std::string& key) {
                                const bool elsewhere =
                                    !specification.points().empty() || !specification.preloads().empty();
                                return !estimation::isOfSheet(key) || !(elsewhere || specification.has(key));
                              }),
               keys.end());
    checkKeys(entry, keys);
    if (entry.node.size() == 0) {
      refuseContent(entry, "a map of " + log::join(keys));
    }
    estimation::SheetTolerance tolerance;
    for (const auto& of_key : entry.node) {
      tolerance.by_key[of_key.first.Scalar()] = loadSheetShare(entry[of_key.first.Scalar()]);
    }
    return tolerance;
  }

  double loadSheetShare(const Entry& entry) {
    if (entry.isText() && entry.text() == kGuess) {
      return estimation::SheetTolerance::kGuess;
    }
    if (!entry.isText() || !startsAsNumber(entry.text())) {
      refuse(entry, fmt::format("{} is not a tolerance{}; accepted: a share such as 10 %, {}, or a map of such by key",
                                kindOf(entry.node), hintOf(entry.node, {kGuess}), kGuess));
    }
    return loadNumber(entry, anyNumber("1", element::Range::openBelow(0.0, 1.0)));
  }

  // The index of a word among those accepted.
  std::size_t loadWord(const Entry& entry, const std::vector<std::string>& words) const {
    const auto found = entry.isText() ? std::find(words.begin(), words.end(), entry.text()) : words.end();
    if (found == words.end()) {
      refuse(entry, fmt::format("{}{}; accepted: {}", kindOf(entry.node), hintOf(entry.node, words),
                                fmt::join(words, " or ")));
    }
    return static_cast<std::size_t>(found - words.begin());
  }

  bool loadFlag(const Entry& entry) const { return loadWord(entry, {"false", "true"}) == 1; }

  // Whether something is to scale with the static curve.
  bool loadScale(const Entry& entry) const { return loadWord(entry, {"static_curve", "none"}) == 0; }

  estimation::StaticCurve loadCurve(const Entry& entry, const Entry& scale) {
    using Curve = estimation::StaticCurve;
    static const std::vector<Key<Curve>> keys = {into("displacement", &Curve::displacement, numbersIn("m"), "a list"),
                                                 into("force", &Curve::force, numbersIn("N"), "a list"),
                                                 into("monotone", &Curve::monotone, &Loader::loadFlag)};
    Curve curve;
    read(entry, keys, curve, "a map with the lists displacement and force");
    curve.scales = !scale || loadScale(scale);
    try {
      curve.check();
    } catch (const std::invalid_argument& error) {
      refuseAt(entry.node, std::string("specification.") + error.what());
    }
    return curve;
  }

  // A list of maps, each read by `load`.
  template <class Value, class Load>
  std::vector<Value> loadMaps(const Entry& list, Load load) {
    if (!list.node.IsSequence() || list.node.size() == 0 || list.node.size() > kMaximumElements) {
      refuseContent(list, fmt::format("a list of 1 to {} maps", kMaximumElements));
    }
    std::vector<Value> values;
    for (std::size_t i = 0; i < list.node.size(); ++i) {
      requireMap(list[i]);
      values.push_back(load(list[i]));
    }
    return values;
  }

  estimation::SpecifiedPoint loadPoint(const Entry& entry) {
    using Point = estimation::SpecifiedPoint;
    static const std::vector<Key<Point>> keys = {
        into("frequency", &Point::frequency, as("nominal_frequency"), "a frequency"),
        into("amplitude", &Point::amplitude, as("nominal_amplitude")),
        into("stiffness", &Point::stiffness, as("dynamic_stiffness")),
        into("loss_angle", &Point::loss_angle, as("loss_angle")),
        into("weight", &Point::weight, [](Loader& loader, const Entry& value) {
          return loader.loadNumber(value, anyNumber("1", element::Range::positive()));
        })};
    Point point;
    read(entry, keys, point);
    return point;
  }

  // The message begins with the key that is to blame, whose line it gets; without one, that of the whole map.
  [[noreturn]] void refuseSpecification(const Entry& map, const std::string& message) const {
    const Entry value = map[message.substr(0, message.find_first_of(":.[ "))];
    refuseAt(value ? value.node : map.node, "specification." + message);
  }

  // A row of a table as the direction that is being read has it.
  element::ParameterInfo here(element::ParameterInfo parameter) const {
    parameter.unit = rotational_ ? rotationalUnit(parameter.unit) : parameter.unit;
    return parameter;
  }

  double loadNumber(const Entry& entry, const element::ParameterInfo& row) {
    const element::ParameterInfo parameter = here(row);
    if (!entry.isText()) {
      refuse(entry, fmt::format("{} is not a number; accepted: {}", kindOf(entry.node), accepted(parameter)));
    }
    const std::string text = log::quoted(entry.text());
    double value = 0.0;
    std::string unit;
    try {
      value = log::parseQuantity(entry.text(), parameter.unit);
      unit = log::unitOfQuantity(entry.text());
    } catch (const std::invalid_argument& error) {
      refuse(entry, fmt::format("{}: {}; accepted: {}", text, error.what(), accepted(parameter)));
    }
    if (!unit.empty() && parameter.unit != "1" && parameter.unit != "K" && parameter.unit != "degC") {
      units_.emplace(parameter.unit, unit);
    }
    // "50 degC" is a temperature, and 323 K; what is wanted in K is a difference of two.
    if (!unit.empty() && parameter.unit == "K" && log::UnitConversion(unit, parameter.unit)(0.0) != 0.0) {
      refuse(entry,
             fmt::format("{} is a temperature, not a difference of two; accepted: {}", text, accepted(parameter)));
    }
    constexpr double kLongestTime = 1e12;  // [s], 30,000 years: steps through more never end
    const double most = parameter.unit == "s" ? kLongestTime : element::kLargestNumber;
    if (std::isfinite(value) && std::abs(value) > most) {
      refuse(entry, fmt::format("{} is beyond what a component can have; accepted: at most {:g} {}", text, most,
                                parameter.unit));
    }
    if (!parameter.range.contains(value)) {
      refuse(entry,
             fmt::format("{} is {}; accepted: {}{}", text, std::isfinite(value) ? "out of range" : "not finite",
                         acceptedIn(unit, parameter),
                         parameter.name == "maxwell_elements" && value == 1.0 ? ", or model: maxwell for one" : ""));
    }
    return value;
  }

  std::vector<double> loadNumbers(const Entry& entry, const element::ParameterInfo& parameter) {
    if (!parameter.is_list || entry.isText()) {
      return {loadNumber(entry, parameter)};
    }
    if (!entry.node.IsSequence() || entry.node.size() == 0 || entry.node.size() > kMaximumListLength) {
      refuseContent(entry,
                    fmt::format("a list of 1 to {} numbers, each {}", kMaximumListLength, accepted(here(parameter))));
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < entry.node.size(); ++i) {
      values.push_back(loadNumber(entry[i], parameter));
    }
    return values;
  }

  // They may scale along the curve of a specification, where there is one.
  std::vector<element::ElementDescription> loadElements(const Entry& list,
                                                        const estimation::Specification* specification = nullptr) {
    if (!list.node.IsSequence()) {
      refuseContent(list, "a list of elements");
    }
    if (list.node.size() > kMaximumElements) {
      refuse(list, fmt::format("{} elements; accepted: at most {}", list.node.size(), kMaximumElements));
    }
    std::vector<element::ElementDescription> elements;
    for (std::size_t i = 0; i < list.node.size(); ++i) {
      elements.push_back(loadElement(list[i], specification));
    }
    return elements;
  }

  const element::ElementType& loadType(const Entry& entry) {
    requireMap(entry, "a map with the key 'type'");
    checkUnique(entry);
    const std::vector<std::string> names = namesOf(element::elementTypes());
    const Entry type = require(entry, "type", log::join(names));
    const element::ElementType* found = type.isText() ? element::findElementType(type.text()) : nullptr;
    if (found == nullptr) {
      refuseWord(type, "an element", names);
    }
    return *found;
  }

  element::ElementDescription loadElement(const Entry& entry, const estimation::Specification* specification) {
    checkCancelled();
    const element::ElementType& type = loadType(entry);
    std::vector<std::string> keys = namesOf(type.parameters);
    keys.insert(keys.begin(), "type");
    keys.insert(keys.end(), {"scale_with", "of_rig"});
    checkKeys(entry, keys);
    element::ElementDescription description;
    description.type = type.name;
    for (const element::ParameterInfo& parameter : type.parameters) {
      if (!parameter.default_value || entry[parameter.name]) {
        const Entry value = require(entry, parameter.name, accepted(here(parameter)));
        description.values[parameter.name] = loadNumbers(value, parameter);
      }
    }
    try {
      const bool of_chain = element::lawOf(element::makeElement(description)).ofMeasuringChain();
      if (const Entry mark = entry["of_rig"]) {
        description.of_rig = loadFlag(mark) && !of_chain;
        if (of_chain && !loadFlag(mark)) {
          refuse(mark, "false; accepted: true, as what a measuring chain does is never of the rubber");
        }
      }
      return scaled(description, entry["scale_with"], specification);
    } catch (const std::invalid_argument& error) {
      refuse(entry, error.what());
    }
  }

  element::ElementDescription scaled(const element::ElementDescription& description, const Entry& scale,
                                     const estimation::Specification* specification) const {
    if (!scale || !loadScale(scale)) {
      return description;
    }
    const estimation::StaticCurve* curve = specification == nullptr ? nullptr : specification->curve();
    if (curve == nullptr) {
      refuse(scale, "the component has no static_curve; accepted: none, or a static_curve in its specification");
    }
    element::ElementDescription scaled =
        estimation::scaledAlong(*curve, estimation::nominalDisplacement(*specification), description);
    scaled.of_rig = description.of_rig;
    return scaled;
  }

  std::string source_;
  std::string component_;                     // the one being read, for errors
  std::map<std::string, std::string> units_;  // of its numbers, by the SI unit
  // The direction being read, of a component of six.
  std::string place_;
  bool rotational_ = false;
  std::optional<component::Preload> preload_;
  // A key without value: YAML places the nothing at the token that follows, perhaps lines below. By position, the key's
  // line.
  std::map<int, int> lines_of_nothing_;
};

// The shortest text that reads back as the same number.
std::string number(double value) { return fmt::format("{}", value); }

std::string listYaml(const std::vector<double>& values) {
  std::vector<std::string> numbers(values.size());
  std::transform(values.begin(), values.end(), numbers.begin(), number);
  return fmt::format("[{}]", log::join(numbers));
}

std::string styled(const YamlStyle& style, const std::string& place, double value) {
  return style.number ? style.number(place, value) : number(value);
}

std::string entryYaml(const std::string& place, const element::ElementDescription& entry, const YamlStyle& style) {
  std::string text = fmt::format("{{type: {}", entry.type);
  std::string notes;
  for (const auto& [name, values] : entry.values) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string number_place = numberPlace(place, name, values.size() > 1 ? static_cast<int>(i) : -1);
      numbers.push_back(styled(style, number_place, values[i]));
      const std::string note = style.note ? style.note(number_place) : "";
      notes += note.empty() ? "" : fmt::format("      # {}: {}\n", number_place.substr(place.size() + 1), note);
    }
    text += fmt::format(", {}: {}", name, values.size() == 1 ? numbers[0] : fmt::format("[{}]", log::join(numbers)));
  }
  return fmt::format("{}      - {}{}}}\n", notes, text, element::isOfRig(entry) ? ", of_rig: true" : "");
}

std::string entriesYaml(const std::string& key, const std::vector<element::ElementDescription>& entries,
                        const YamlStyle& style) {
  std::string text = entries.empty() ? "" : fmt::format("    {}:\n", key);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    text += entryYaml(fmt::format("{}[{}]", key, i), entries[i], style);
  }
  return text;
}

std::string temperatureYaml(const element::ElementDescription& description) {
  const auto& laws = shiftLaws();
  const auto law =
      std::find_if(laws.begin(), laws.end(), [&](const ShiftLaw& known) { return known.type == description.type; });
  std::string text = fmt::format("    temperature: {{shift: {}", law->name);
  for (const auto& [name, values] : description.values) {
    text += fmt::format(", {}: {}", name, number(values.at(0)));
  }
  return text + "}\n";
}

std::string rigYaml(const RigTolerances& tolerances) {
  std::string text = "    rig:\n";
  for (const RigToleranceInfo& row : rigToleranceTable()) {
    text += fmt::format("      {}: {}\n", row.name, toString(row, tolerances.*row.member));
  }
  return text;
}

std::string curveYaml(const estimation::StaticCurve& curve, bool turns) {
  return fmt::format(
      "      static_curve:\n        displacement: {}  # [{}]\n        force: {}  # [{}]\n{}      scale_with: {}\n",
      listYaml(curve.displacement), turns ? "rad" : "m", listYaml(curve.force), turns ? "N m" : "N",
      curve.monotone ? "        monotone: true\n" : "", curve.scales ? "static_curve" : "none");
}

std::string toleranceYaml(const estimation::SheetTolerance& tolerance) {
  const auto share = [](double value) { return value == estimation::SheetTolerance::kGuess ? kGuess : number(value); };
  std::vector<std::string> by_key;
  for (const auto& [key, value] : tolerance.by_key) {
    by_key.push_back(fmt::format("{}: {}", key, share(value)));
  }
  return fmt::format("      tolerance: {}\n",
                     tolerance.of_all ? share(*tolerance.of_all) : fmt::format("{{{}}}", log::join(by_key)));
}

// `added`: then it has to say that it describes the base. `turns`: it is that of a rotation.
std::string specificationYaml(const estimation::Specification& specification, bool added, bool turns,
                              const YamlStyle& style) {
  std::string text = "    specification:\n";
  if (added || specification.describes() != estimation::Describes::unsaid) {
    text += "      describes: base\n";
  }
  text += specification.tolerance().given() ? toleranceYaml(specification.tolerance()) : "";
  text += specification.curve() == nullptr ? "" : curveYaml(*specification.curve(), turns);
  for (const estimation::Specification::Values& block : specification.preloads()) {
    text += &block == &specification.preloads().front() ? "      preloads:\n" : "";
    std::vector<std::string> numbers;
    for (const auto& [key, value] : block) {
      numbers.push_back(fmt::format("{}: {}", key, number(value)));
    }
    text += fmt::format("        - {{{}}}\n", log::join(numbers));
  }
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    if (specification.has(parameter.name)) {
      const std::string place = "specification." + parameter.name;
      const std::string value = styled(style, place, specification.at(parameter.name));
      const std::string note = style.note ? style.note(place) : "";
      const bool says_unit = parameter.unit == "1" || value.find(' ') != std::string::npos;
      text += fmt::format("      {}: {}", parameter.name, value);
      text += says_unit && note.empty()
                  ? "\n"
                  : fmt::format(
                        "  #{}{}{}\n",
                        says_unit ? "" : fmt::format(" [{}]", turns ? rotationalUnit(parameter.unit) : parameter.unit),
                        note.empty() ? "" : " ", note);
    }
  }
  return text;
}

// Model and what belongs to it, of a component of one direction; `turns`: a rotation.
std::string oneDirectionYaml(const ComponentDescription& component, bool turns, const YamlStyle& style) {
  std::string text = fmt::format("    model: {}\n", estimation::toString(component.model()));
  text += component.model() == estimation::Model::elements
              ? entriesYaml("elements", component.elements(), style)
              : specificationYaml(component.specification(), !component.add.empty(), turns, style);
  text += entriesYaml("add", component.add, style);
  text += component.temperature ? temperatureYaml(*component.temperature) : "";
  text += component.rig ? rigYaml(*component.rig) : "";
  if (const auto& valid = component.valid_displacement) {
    text += fmt::format("    valid_displacement: [{}, {}]  # [{}]\n", valid->lower, valid->upper, turns ? "rad" : "m");
  }
  if (!component.excluded_effects.empty()) {
    text += fmt::format("    excluded_effects: [{}]\n", fmt::join(component.excluded_effects, ", "));
  }
  text += component.holds_fluid ? "    holds_fluid: true\n" : "";
  return text;
}

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    result += "    " + line + "\n";
  }
  return result;
}

std::string preloadYaml(const component::Preload& preload, component::Direction direction) {
  const bool turns = component::isRotation(direction);
  return number(preload.value) + (preload.is_force ? (turns ? " N m" : " N") : (turns ? " rad" : " m"));
}

std::string tableYaml(const component::PreloadTable& table) {
  std::vector<std::string> loads;
  for (const component::Preload& preload : table.preload) {
    loads.push_back(preloadYaml(preload, table.by));
  }
  return fmt::format("      - {{direction: {}, by: {}, preload: [{}], factor: {}}}\n", toString(table.direction),
                     toString(table.by), log::join(loads), listYaml(table.factor));
}

// The style of all for one direction.
YamlStyle styleOf(component::Direction direction, const YamlStyle& style) {
  const std::string prefix = fmt::format("directions.{}.", toString(direction));
  YamlStyle own;
  if (style.number) {
    own.number = [&style, prefix](const auto& place, double value) { return style.number(prefix + place, value); };
  }
  if (style.note) {
    own.note = [&style, prefix](const auto& place) { return style.note(prefix + place); };
  }
  return own;
}

std::string sixDirectionsYaml(const SixDirectionsDescription& six, const YamlStyle& style) {
  std::string text = "    directions:\n";
  std::vector<std::string> preloads;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const auto direction = static_cast<component::Direction>(i);
    if (six.directions[i]) {
      text +=
          fmt::format("      {}:\n", toString(direction)) +
          indented(oneDirectionYaml(*six.directions[i], component::isRotation(direction), styleOf(direction, style)));
    }
    if (six.preload[i]) {
      preloads.push_back(fmt::format("{}: {}", toString(direction), preloadYaml(*six.preload[i], direction)));
    }
  }
  const component::SixDirectionsLaws& arrangement = six.arrangement;
  text += fmt::format("    coupling: {{translation: {}, rotation: {}, axis: {}}}\n",
                      kCouplings[static_cast<std::size_t>(arrangement.translation)],
                      kCouplings[static_cast<std::size_t>(arrangement.rotation)], kAxes[arrangement.axis]);
  text += fmt::format("    rotation: {}\n    valid_rotation: {}  # [rad]\n",
                      kMeasures[static_cast<std::size_t>(arrangement.measure)], arrangement.valid_rotation);
  text += "    frame:\n";
  for (const auto& [body, frame] : {std::pair("a", &six.frame_on_a), std::pair("b", &six.frame_on_b)}) {
    text += fmt::format("      {}: {{position: {}, rotation: {}}}\n", body,
                        listYaml({frame->begin(), frame->begin() + 3}), listYaml({frame->begin() + 3, frame->end()}));
  }
  text += preloads.empty() ? "" : fmt::format("    preload: {{{}}}\n", log::join(preloads));
  text += six.tables.empty() ? "" : "    stiffness_by_preload:\n";
  for (const component::PreloadTable& table : six.tables) {
    text += tableYaml(table);
  }
  return text;
}

// A preload as a force or as a displacement, whichever a table asks for; by the static curve, where the other is given.
double preloadAs(bool force, const SixDirectionsDescription& six, component::Direction direction) {
  const std::optional<component::Preload>& preload = six.preload[direction];
  if (!preload || !six.directions[direction]) {
    throw std::invalid_argument(
        fmt::format("needs the preload of {}; accepted: preload.{}", toString(direction), toString(direction)));
  }
  if (preload->is_force == force) {
    return preload->value;
  }
  const estimation::StaticCurve* curve = six.directions[direction]->written().curve();
  if (curve == nullptr) {
    throw std::invalid_argument(
        fmt::format("is over a {}, preload.{} is a {} and {} has no static_curve; accepted: a {}",
                    force ? "force" : "displacement", toString(direction), force ? "displacement" : "force",
                    toString(direction), force ? "table over displacements" : "table over forces"));
  }
  return force ? curve->forceAt(preload->value) : curve->displacementAt(preload->value);
}

std::vector<element::ElementDescription> ofRubber(std::vector<element::ElementDescription> elements) {
  elements.erase(std::remove_if(elements.begin(), elements.end(), element::isOfRig), elements.end());
  return elements;
}

}  // namespace

ComponentFileError::ComponentFileError(const std::string& message) : std::runtime_error(log::oneLine(message)) {}

ComponentDescription::ComponentDescription(std::string component, estimation::Model model,
                                           estimation::Specification specification,
                                           std::vector<element::ElementDescription> added)
    : name(std::move(component)), add(std::move(added)), model_(model) {
  specify(std::move(specification));
}

void ComponentDescription::specify(estimation::Specification specification) {
  if (model_ == estimation::Model::elements) {
    throw std::logic_error("the model elements has no specification");
  }
  estimation::Resolved resolved = estimation::resolve(model_, specification, ofRubber(add));
  elements_ = estimation::estimate(model_, resolved.specification);
  resolved_ = std::move(resolved);
  written_ = std::move(specification);
}

ComponentDescription ComponentDescription::withoutRig() const {
  ComponentDescription result = *this;
  result.elements_ = ofRubber(elements_);
  result.add = ofRubber(add);
  if (six) {
    auto directions = std::make_shared<SixDirectionsDescription>(*six);
    for (std::optional<ComponentDescription>& direction : directions->directions) {
      direction = direction ? std::optional(direction->withoutRig()) : std::nullopt;
    }
    result.six = std::move(directions);
  }
  return result;
}

std::vector<element::ElementDescription> ComponentDescription::allElements() const {
  if (six) {
    throw std::invalid_argument(
        fmt::format("component '{}' has six directions; accepted here: a component of one direction", name));
  }
  std::vector<element::ElementDescription> all = elements_;
  all.insert(all.end(), add.begin(), add.end());
  if (temperature) {
    all.push_back(*temperature);
  }
  return all;
}

std::optional<element::Range> ComponentDescription::validDisplacement() const {
  constexpr double kAmplitudes = 3.0;
  if (valid_displacement || six) {
    return valid_displacement;
  }
  if (const std::optional<double> nominal = written().find("nominal_amplitude")) {
    return element::Range::closed(-kAmplitudes * *nominal, kAmplitudes * *nominal);
  }
  std::optional<element::Range> common;
  for (const element::ElementDescription& element : allElements()) {
    if (element.type == "spring_table") {
      const std::vector<double>& displacement = element.values.at("displacement");
      const auto ends = element::Range::closed(displacement.front(), displacement.back());
      common = common ? element::intersection(*common, ends) : ends;
    }
  }
  return common;
}

double SixDirectionsDescription::factorOf(component::Direction direction) const {
  double factor = 1.0;
  for (const component::PreloadTable& table : tables) {
    if (table.direction == direction) {
      factor *= table.factorAt(preloadAs(table.preload.front().is_force, *this, table.by));
    }
  }
  return factor;
}

component::SixDirections SixDirectionsDescription::makeComponent() const {
  component::SixDirectionsLaws laws = arrangement;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    if (directions[i]) {
      laws.elements[i] = directions[i]->allElements();
      const double factor = factorOf(static_cast<component::Direction>(i));
      if (factor != 1.0) {
        component::scaleForces(laws.elements[i], factor);
      }
    }
  }
  return component::SixDirections(std::move(laws));
}

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

const ComponentDescription& selectComponent(const std::vector<ComponentDescription>& components,
                                            const std::string& name, const std::string& source) {
  if (name.empty() && components.size() == 1) {
    return components.front();
  }
  std::vector<std::string> names;
  for (const ComponentDescription& component : components) {
    if (component.name == name) {
      return component;
    }
    names.push_back(component.name);
  }
  const std::string problem =
      name.empty() ? "more than one component; accepted: the name of one of "
                   : fmt::format("no component '{}'{}; accepted: ", name, element::didYouMean(name, names));
  throw ComponentFileError((source.empty() ? "" : source + ": ") + problem + log::join(names));
}

std::string numberPlace(const std::string& entry, const std::string& key, int index) {
  return fmt::format("{}.{}{}", entry, key, index < 0 ? "" : fmt::format("[{}]", index));
}

std::string toYaml(const std::vector<ComponentDescription>& components, const YamlStyle& style) {
  std::string text = style.head + "components:\n";
  for (const ComponentDescription& component : components) {
    if (!isBaseName(component.name)) {
      throw ComponentFileError(
          fmt::format("{}: no name of a component; accepted: letters, digits and underscores, a letter "
                      "first, at most {}",
                      log::quoted(component.name), kMaximumNameLength));
    }
    text += fmt::format("  {}:\n", component.name) +
            (component.six ? sixDirectionsYaml(*component.six, style) : oneDirectionYaml(component, false, style));
  }
  return text;
}

}  // namespace rubber_suspension::io
