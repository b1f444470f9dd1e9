// Factors of a preload, and scaling of elements.
#include "rubber_suspension/component/preload.h"

#include <algorithm>

namespace rubber_suspension::component {

double PreloadTable::factorAt(double value) const {
  const auto after =
      std::find_if(preload.begin(), preload.end(), [&](const Preload& point) { return point.value > value; });
  const auto i = static_cast<std::size_t>(after - preload.begin());
  if (i == 0 || i == preload.size()) {
    return i == 0 ? factor.front() : factor.back();
  }
  const double share = (value - preload[i - 1].value) / (preload[i].value - preload[i - 1].value);
  return factor[i - 1] + share * (factor[i] - factor[i - 1]);
}

void scaleForces(std::vector<element::ElementDescription>& elements, double factor) {
  for (element::ElementDescription& element : elements) {
    for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
      const auto values = element.values.find(parameter.name);
      if (parameter.role == element::Role::scale && values != element.values.end()) {
        std::for_each(values->second.begin(), values->second.end(), [&](double& value) { value *= factor; });
      }
    }
  }
}

}  // namespace rubber_suspension::component
