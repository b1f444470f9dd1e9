// Mathematical constants. Throws nothing.
#pragma once

namespace rubber_suspension::element {

constexpr double kPi = 3.14159265358979323846;  ///< ratio of a circle's circumference to its diameter

}  // namespace rubber_suspension::element
