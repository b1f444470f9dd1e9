// Iwan's friction: a bank of Jenkins sliders with the backbone of Berg's element, or with sliders given one by one.
#pragma once

#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::element {

/// Sliders whose backbone lies on a hyperbola like Berg's, F = c z/(z2' + z), at each yield displacement, with F =
/// F_max/2 at z2 and F = F_max at the greatest yield displacement. The yield displacements are in geometric progression
/// up to 50 z2, the middle one being z2 itself; with n sliders their ratio is 50^(1/(n - n/2)). Below the least one the
/// element is a spring without loss. With equal F_max and z2 its settled peak force is higher than that of Berg's
/// element (for amplitude 2, F_max 5, z2 2.2: 2.37 against 1.99), so parameters do not carry over from one to the
/// other.
std::vector<JenkinsSlider> iwanSliders(double maximum_force /* F_max [N] */, double displacement /* z2 [m] */,
                                       int count /* n, at least 2 */);

/// Sliders from the lists yield_displacement and stiffness of an entry. Throws std::invalid_argument where they do not
/// go together.
std::vector<JenkinsSlider> slidersFromTable(const ElementDescription& description);

}  // namespace rubber_suspension::element
