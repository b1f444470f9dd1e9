// Values of specifications by key, with operators that add, replace and remove values.
#pragma once

#include <map>
#include <string>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension {

using Values = std::map<std::string, double>;

inline Values operator+(Values values, const Values& more) {
  for (const auto& [key, value] : more) {
    values[key] = value;
  }
  return values;
}

inline Values with(Values values, const std::string& key, double value) {
  values[key] = value;
  return values;
}

inline Values without(Values values, const std::string& key) {
  values.erase(key);
  return values;
}

inline estimation::Specification specificationOf(const Values& values,
                                                 estimation::Describes describes = estimation::Describes::component) {
  estimation::Specification specification;
  for (const auto& [key, value] : values) {
    specification.set(key, value);
  }
  specification.describe(describes);
  return specification;
}

inline std::vector<element::ElementDescription> estimated(estimation::Model model, const Values& values) {
  return estimation::estimate(model, specificationOf(values, estimation::Describes::unsaid));
}

}  // namespace rubber_suspension
