// Notes on an estimation.
#include "rubber_suspension/estimation/notes.h"

#include <fmt/format.h>

#include "estimation/models.h"

namespace rubber_suspension::estimation {
namespace {

std::vector<std::string> multiMaxwellNotes(const Specification& specification) {
  const Band band = multiMaxwellBand(specification);
  std::vector<std::string> notes;
  if (!specification.has("low_frequency")) {
    notes.push_back(
        fmt::format("low_frequency is {:.6g} Hz by f_l = n_M f_h/10^(n_M-1), a reconstruction of the "
                    "illegible Eq. 22 of the paper; give low_frequency to choose it",
                    band.low_frequency));
  }
  if (!specification.has("high_frequency")) {
    notes.push_back(
        fmt::format("high_frequency found from the loss angle is {:.6g} Hz; where several give it, this is "
                    "the lowest above nominal_frequency",
                    band.high_frequency));
  }
  return notes;
}

}  // namespace

std::vector<std::string> estimationNotes(Model model, const Specification& specification) {
  switch (model) {
    case Model::kelvin_voigt: {
      std::vector<std::string> notes = {
          "dynamic_stiffness is taken as the storage stiffness (Eq. 11): the loop's stiffness is K_n/cos(loss angle)"};
      if (specification.has("static_stiffness")) {
        notes.push_back("static_stiffness is not used by kelvin_voigt, whose static stiffness is dynamic_stiffness");
      }
      return notes;
    }
    case Model::friction_dashpot:
      return {
          "dynamic_stiffness holds between the turning points, where the dashpot has no force; the peak of the loop "
          "comes a little earlier and is a little higher"};
    case Model::multi_maxwell:
      return multiMaxwellNotes(specification);
    default:
      return {};
  }
}

}  // namespace rubber_suspension::estimation
