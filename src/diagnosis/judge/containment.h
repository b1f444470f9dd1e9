// Which laws have others as limits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rubber_suspension::diagnosis::judge {

/// The effects whose laws the law of an effect has as limits, so that it can do all that these do; none for most.
const std::vector<std::string>& containedIn(const std::string& effect);

/// One, or as many as these laws are: what does the work of two is as seldom as two.
std::size_t mechanismsOf(const std::string& effect);

}  // namespace rubber_suspension::diagnosis::judge
