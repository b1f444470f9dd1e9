// Iwan's friction: a bank of Jenkins sliders, which approximate a hyperbola or are listed in the component file.
#pragma once

#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::element {

/// Returns sliders whose backbone meets a hyperbola like Berg's, F = c z/(z2' + z), at each yield displacement. F is
/// F_max/2 at z2 and F_max at the greatest yield displacement. The yield displacements are in geometric progression
/// through z2 up to 50 z2; with n sliders their ratio is 50^(1/(n - n/2)), where n/2 is rounded down. At amplitudes
/// below the smallest yield displacement the element is a spring without loss. With equal F_max and z2 the settled peak
/// force is larger than with Berg's element (2.37 instead of 1.99 for amplitude 2, F_max 5 and z2 2.2), so parameters
/// of Berg's element do not suit this element.
std::vector<JenkinsSlider> iwanSliders(double maximum_force /* F_max [N] */, double displacement /* z2 [m] */,
                                       int count /* n, at least 2 */);

/// Returns sliders from the lists yield_displacement and stiffness of an entry. Throws std::invalid_argument unless
/// both lists have the same length, from 1 to 64.
std::vector<JenkinsSlider> slidersFromTable(const ElementDescription& description);

}  // namespace rubber_suspension::element
