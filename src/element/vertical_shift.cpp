// Shift of the force with temperature.
#include "element/registry.h"
#include "element/shift_parts.h"

namespace rubber_suspension::element {
namespace {

const ElementEntry kVerticalShiftEntry(
    370, {"vertical_shift",
          "Shift of only the force, not the rates, with temperature, b_T = 1 + beta (T - T_0).",
          {verticalParameter("coefficient", std::nullopt), referenceParameter()},
          makes<VerticalShift>("coefficient", "reference")});

}  // namespace
}  // namespace rubber_suspension::element
