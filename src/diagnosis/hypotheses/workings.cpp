// Effects that are ruled out.
#include "diagnosis/hypotheses/workings.h"

#include <algorithm>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "io/effect_names.h"
#include "log/text.h"

namespace rubber_suspension::diagnosis::hypotheses {

std::vector<std::string> excludedEffects(const io::ComponentDescription& component, const DiagnosisOptions& options) {
  std::vector<std::string> excluded = component.excluded_effects;
  const std::vector<std::string>& names = io::effectNames();
  for (const std::string& effect : options.excluded) {
    element::refuseIf(std::find(names.begin(), names.end(), effect) == names.end(),
                      "excluded: no effect '{}'{}; accepted: {}", effect, element::didYouMean(effect, names),
                      log::join(names));
    excluded.push_back(effect);
  }
  return excluded;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
