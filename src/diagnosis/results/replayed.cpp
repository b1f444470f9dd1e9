// Errors of components under the displacement as recorded.
#include "diagnosis/results/replayed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/hypotheses/unseen_logs.h"
#include "gap/simulate.h"

namespace rubber_suspension::diagnosis::results {
namespace {

std::vector<gap::PartError> heldOutErrors(const fit::Hypothesis& hypothesis, const Entries& elements,
                                          const HeldOut& held_out) {
  return hypotheses::unseenErrors(hypothesis, elements, gap::simulateEach(elements, held_out.records), held_out.records,
                                  held_out.zeros);
}

// Replayed, and what each block leaves more where it took no part in the fit: over a log never less than is replayed,
// though blocks of a short log may by chance leave less than the fit to all of them.
std::vector<gap::PartError> errorsOfTheFit(const fit::Fitter& fitter, const FittedLaw& fitted,
                                           const Entries& elements) {
  const std::vector<log::Record>& records = fitter.records();
  const fit::Hypothesis hypothesis = fitted.law.hypothesis();
  // Zeros of the displacement are those of the component that is replayed.
  const std::vector<double> none(records.size(), 0.0);
  const std::vector<double> replay = hypotheses::errorsByLog(
      hypotheses::unseenErrors(hypothesis, elements, gap::simulate(elements, records, gap::asRecorded), records,
                               fitter.zeros()),
      none);
  const gap::Forces fit = *LawForces(fitter.sharedRecords(), fitter.model(), fitted.law).at(fitted.fit.parameters);
  const std::vector<double> of_fit = hypotheses::errorsByLog(hypotheses::partErrorsOf(hypothesis, records, fit), none);
  std::vector<gap::PartError> blocks = fitted.fit.blocks;
  const std::vector<double> unseen = hypotheses::errorsByLog(blocks, none);
  for (gap::PartError& block : blocks) {
    const auto log = static_cast<std::size_t>(block.log);
    const double error = block.error + replay[log] - std::min(of_fit[log], unseen[log]);
    block.error = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(0.0, error);
  }
  return blocks;
}

}  // namespace

Entries elementsOf(const fit::ModelParameters& model, const FittedLaw& fitted) {
  Entries elements = *model.elements(fitted.fit.parameters.model);
  for (const Entries& entries : fitted.law.at(fitted.fit.parameters.scales)) {
    elements.insert(elements.end(), entries.begin(), entries.end());
  }
  return elements;
}

Replayed replayed(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                  const HeldOut& held_out) {
  return {errorsOfTheFit(fitter, fitted, elements), held_out.records.empty()
                                                        ? std::vector<gap::PartError>()
                                                        : heldOutErrors(fitted.law.hypothesis(), elements, held_out)};
}

std::vector<gap::PartError> unseenErrors(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                                         const HeldOut& held_out) {
  return held_out.records.empty() ? errorsOfTheFit(fitter, fitted, elements)
                                  : heldOutErrors(fitted.law.hypothesis(), elements, held_out);
}

}  // namespace rubber_suspension::diagnosis::results
