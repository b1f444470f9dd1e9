// Since when a model's error is what it is: the most likely change of its level.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace rubber_suspension::diagnosis::live {

/// A change between two stretches of a sequence.
struct ChangePoint {
  std::size_t first = 0;    ///< place of the first value behind it
  double likelihood = 0.0;  ///< logarithm of the ratio of likelihoods, with the change to without it
  double before = 0.0;      ///< mean of the stretch before
  double after = 0.0;       ///< and of that behind
};

/// The most likely change of mean and spread of normal values (Hinkley, Biometrika 57, 1970), if there is one: if the
/// ratio of likelihoods exceeds what the best of all places gives by chance. Both stretches have at least kShortest
/// values.
std::optional<ChangePoint> mostLikelyChange(const std::vector<double>& values);

/// The last change: the sequence is cut at the most likely one, and what is behind it again, until there is none
/// (binary segmentation: Scott and Knott, Biometrics 30, 1974).
std::optional<ChangePoint> lastChange(const std::vector<double>& values);

}  // namespace rubber_suspension::diagnosis::live
