// Names and words of component files, for reader and writer alike.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

constexpr std::size_t kMaximumNameLength = 100;

/// Name of a law in the key `temperature`.
struct ShiftLaw {
  std::string name;
  std::string type;  ///< of the element
};

const std::vector<ShiftLaw>& shiftLaws();

// In the order of the enumerations that they stand for.
const std::vector<std::string> kCouplings = {"rectangular", "cylindrical", "spherical"};
const std::vector<std::string> kMeasures = {"vector", "cardan"};
const std::vector<std::string> kAxes = {"x", "y", "z"};

constexpr const char* kGuess = "guess";  // of a tolerance

/// A letter, then letters, digits and underscores.
bool isBaseName(const std::string& name);

}  // namespace rubber_suspension::io
