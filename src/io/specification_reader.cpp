// Reader of specifications, which uses the tables of specification keys and models.
#include "io/specification_reader.h"

#include <algorithm>

#include "io/component_words.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::io {
namespace {

using element::namesOf;

}  // namespace

ComponentDescription SpecificationReader::loadSpecification(const Entry& entry, estimation::Model model,
                                                            const Entry& add) {
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

std::vector<element::ElementDescription> SpecificationReader::loadAdded(
    const Entry& add, const estimation::Specification& specification) {
  return add ? loadElements(add, &specification) : std::vector<element::ElementDescription>{};
}

void SpecificationReader::preloadSpecification(const Entry& entry, estimation::Specification& specification) const {
  if (!preload_) {
    return;
  }
  const std::string own = preload_->is_force ? "nominal_force" : "nominal_displacement";
  for (const char* key : {"nominal_force", "nominal_displacement"}) {
    if (const auto given = specification.find(key); given && !(key == own && *given == preload_->value)) {
      refuse(entry[key], "is given together with another preload of this direction; accepted: only one of them");
    }
  }
  if (specification.curve() != nullptr) {
    specification.set(own, preload_->value);
  }
}

estimation::Specification SpecificationReader::loadValues(const Entry& entry, const std::vector<std::string>& others) {
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

void SpecificationReader::loadDescribed(const Entry& entry, estimation::Specification& specification) {
  if (const Entry describes = entry["describes"]) {
    specification.describe(loadWord(describes, {"component", "base"}) == 0 ? estimation::Describes::component
                                                                           : estimation::Describes::base);
  }
  if (const Entry curve = entry["static_curve"]) {
    specification.setCurve(loadCurve(curve, entry["scale_with"]));
  } else if (const Entry scale = entry["scale_with"]) {
    refuse(scale, "is given without static_curve; accepted: both or neither");
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

estimation::SheetTolerance SpecificationReader::loadSheetTolerance(const Entry& entry,
                                                                   const estimation::Specification& specification) {
  if (!entry.node.IsMap()) {
    return {loadTolerance(entry, ", or a map of such values by key")};
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
    tolerance.by_key[of_key.first.Scalar()] = loadTolerance(entry[of_key.first.Scalar()]);
  }
  return tolerance;
}

estimation::StaticCurve SpecificationReader::loadCurve(const Entry& entry, const Entry& scale) {
  using StaticCurve = estimation::StaticCurve;
  const auto numbersIn = [this](const char* unit) {
    return [this, unit](const Entry& value) { return loadNumbers(value, anyNumber(unit)); };
  };
  const std::vector<Key<StaticCurve>> keys = {
      into("displacement", &StaticCurve::displacement, numbersIn("m"), "a list"),
      into("force", &StaticCurve::force, numbersIn("N"), "a list"),
      into("monotone", &StaticCurve::monotone, [this](const Entry& value) { return loadFlag(value); })};
  StaticCurve curve;
  read(entry, keys, curve, "a map with the lists displacement and force");
  curve.scales = !scale || loadScale(scale);
  try {
    curve.check();
  } catch (const std::invalid_argument& error) {
    refuseAt(entry.node, std::string("specification.") + error.what());
  }
  return curve;
}

estimation::SpecifiedPoint SpecificationReader::loadPoint(const Entry& entry) {
  using Point = estimation::SpecifiedPoint;
  const auto as = [this](const char* row) {
    return [this, row](const Entry& value) {
      return loadNumber(value, *element::findParameter(estimation::specificationParameters(), row));
    };
  };
  const std::vector<Key<Point>> keys = {into("frequency", &Point::frequency, as("nominal_frequency"), "a frequency"),
                                        into("amplitude", &Point::amplitude, as("nominal_amplitude")),
                                        into("stiffness", &Point::stiffness, as("dynamic_stiffness")),
                                        into("loss_angle", &Point::loss_angle, as("loss_angle")),
                                        into("weight", &Point::weight, [this](const Entry& value) {
                                          return loadNumber(value, anyNumber("1", element::Range::positive()));
                                        })};
  Point point;
  read(entry, keys, point);
  return point;
}

void SpecificationReader::refuseSpecification(const Entry& map, const std::string& message) const {
  const Entry value = map[message.substr(0, message.find_first_of(":.[ "))];
  refuseAt(value ? value.node : map.node, "specification." + message);
}
}  // namespace rubber_suspension::io
