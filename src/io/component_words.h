// Names and words of component files, which reader and writer share.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

constexpr std::size_t kMaximumNameLength = 100;

struct ShiftLaw {
  std::string name;
  std::string type;  ///< element type of the law
};

const std::vector<ShiftLaw>& shiftLaws();

// Words in the order of the values of component::Coupling, of component::RotationMeasure and of the axes.
const std::vector<std::string> kCouplings = {"rectangular", "cylindrical", "spherical"};
const std::vector<std::string> kMeasures = {"vector", "cardan"};
const std::vector<std::string> kAxes = {"x", "y", "z"};

constexpr const char* kGuess = "guess";  // value of the key `tolerance`

/// Returns true for a letter followed by at most kMaximumNameLength - 1 letters, digits and underscores.
bool isBaseName(const std::string& name);

}  // namespace rubber_suspension::io
