// Headers of the standard library and of others that most files include, parsed once for all files of a layer.
// A file still includes what it uses: clang-tidy and the builds with sanitizers do without this one.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>
