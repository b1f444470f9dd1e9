// Merges and tidies the entries of a fitted hypothesis.
#include "diagnosis/hypotheses/fitted_component.h"

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses {
std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted) {
  const std::vector<fit::BasisTerm>& terms = fitted.hypothesis.terms;
  std::vector<element::ElementDescription> entries;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double scale = fitted.fit.parameters.scales[static_cast<Eigen::Index>(t)];
    if (scale != 0.0) {
      entries.push_back(terms[t].at(scale));
    }
  }
  for (const Effect& effect : effects()) {
    if (effect.tidy != nullptr) {
      effect.tidy(entries);
    }
  }
  return entries;
}

io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted) {
  io::ComponentDescription result = model.apply(fitted.fit.parameters.model);
  const auto entries = entriesOf(fitted);
  result.add.insert(result.add.end(), entries.begin(), entries.end());
  return result;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
