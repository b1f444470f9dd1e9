// Basis terms.
#include "fit/candidate.h"

namespace rubber_suspension::fit {

BasisTerm additiveTerm(const std::string& type, const std::string& scaled, double typical,
                       const element::ParameterValues& others) {
  BasisTerm term;
  term.typical = typical;
  term.at = [=](double scale) {
    element::ElementDescription description{type, others};
    description.values[scaled] = {scale};
    return description;
  };
  return term;
}

}  // namespace rubber_suspension::fit
