// Intervals of a single input: a scan for values with a solution, its edges refined by bisection.
#include "estimation/solvability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rubber_suspension::estimation {
namespace {

constexpr double kReach = 1e4;           // how far the scan goes from the given value, as a factor
constexpr int kPointsPerDecade = 60;     // of the scan
constexpr int kNearPointsPerDecade = 8;  // of the distance to another input of the same unit

bool isCount(const element::ParameterInfo& input) { return input.name == "maxwell_elements"; }

void addScanPoints(std::vector<double>& points, double value) {
  const int steps = static_cast<int>(std::lround(2.0 * std::log10(kReach))) * kPointsPerDecade;
  for (int i = 0; i <= steps; ++i) {
    points.push_back(value / kReach * std::pow(10.0, static_cast<double>(i) / kPointsPerDecade));
  }
}

// Intervals may begin at another input, such as K_n just above K_st, and be narrow.
void addPointsNear(std::vector<double>& points, double value) {
  for (int i = 1; i <= 6 * kNearPointsPerDecade; ++i) {
    const double distance = std::pow(10.0, -static_cast<double>(i) / kNearPointsPerDecade);
    points.push_back(value * (1.0 + distance));
    points.push_back(value * (1.0 - distance));
  }
}

std::vector<double> scanPoints(const Specification& specification, const element::ParameterInfo& input) {
  std::vector<double> points;
  if (isCount(input)) {
    for (double count = input.range.lower; count <= input.range.upper; count += 1.0) {
      points.push_back(count);
    }
    return points;
  }
  addScanPoints(points, specification.at(input.name));
  for (const element::ParameterInfo& other : specificationParameters()) {
    if (other.unit == input.unit && specification.has(other.name)) {
      addPointsNear(points, specification.at(other.name));
    }
  }
  points.erase(std::remove_if(points.begin(), points.end(), [&](double x) { return !input.range.contains(x); }),
               points.end());
  std::sort(points.begin(), points.end());
  return points;
}

// The edge between a value without and a value with a solution.
double edge(double without, double with, const std::function<bool(double)>& solvable) {
  while (std::abs(with - without) > 1e-12 * std::abs(with)) {
    const double middle = 0.5 * (without + with);
    (solvable(middle) ? with : without) = middle;
  }
  return with;
}

// In the unit that the user wrote.
std::string describe(const std::vector<element::Range>& intervals, const element::ParameterInfo& input,
                     const WrittenUnit& unit) {
  std::string text;
  for (element::Range interval : intervals) {
    interval.lower /= unit.size;
    interval.upper /= unit.size;
    const std::string part = isCount(input) && interval.lower == interval.upper ? fmt::format("{:g}", interval.lower)
                                                                                : element::describe(interval);
    text += (text.empty() ? "" : " or ") + part;
  }
  return fmt::format("{} {}{}{}", input.name, text, unit.name == "1" ? "" : " ", unit.name == "1" ? "" : unit.name);
}

}  // namespace

std::vector<element::Range> solvableIntervals(const Specification& specification, const element::ParameterInfo& input,
                                              const Solvable& solvable) {
  const auto withValue = [&](double value) {
    Specification changed = specification;
    changed.set(input.name, value);
    return solvable(changed);
  };
  const std::vector<double> points = scanPoints(specification, input);
  std::vector<element::Range> intervals;
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (withValue(points[i])) {
      if (!inside) {
        const double lower = isCount(input) ? points[i]
                             : i == 0       ? input.range.lower
                                            : edge(points[i - 1], points[i], withValue);
        intervals.push_back(isCount(input) ? element::Range::closed(lower, lower)
                                           : element::Range::open(lower, input.range.upper));
      } else if (isCount(input)) {
        intervals.back().upper = points[i];
      }
      inside = true;
    } else if (inside) {
      if (!isCount(input)) {
        intervals.back().upper = edge(points[i], points[i - 1], withValue);
      }
      inside = false;
    }
  }
  return intervals;
}

std::string describeSolvableInputs(const Specification& specification, const Solvable& solvable) {
  std::string text;
  for (const element::ParameterInfo& input : specificationParameters()) {
    if (!specification.has(input.name)) {
      continue;
    }
    const std::vector<element::Range> intervals = solvableIntervals(specification, input, solvable);
    if (!intervals.empty()) {
      text += (text.empty() ? "" : "; ") + describe(intervals, input, specification.writtenUnit(input.name));
    }
  }
  return text;
}

}  // namespace rubber_suspension::estimation
