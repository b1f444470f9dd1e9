// Intervals of a single input that have a solution: a scan finds them, and bisection refines their limits.
#include "estimation/solvability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "element/each.h"
#include "estimation/models.h"

namespace rubber_suspension::estimation {
namespace {

struct ScanDensity {
  double decades;              // decades on either side of the given value
  int points_per_decade;       // points per decade of the scan
  int near_points_per_decade;  // points per decade of the distance to another input of the same unit
  double tolerance;            // relative error of a limit
};

ScanDensity densityOf(Scan scan) {
  return scan == Scan::fine ? ScanDensity{4.0, 60, 8, 1e-12} : ScanDensity{2.0, 12, 2, 1e-7};
}

bool isCount(const element::ParameterInfo& input) { return input.name == "maxwell_elements"; }

void addScanPoints(std::vector<double>& points, double value, const ScanDensity& density) {
  const int steps = static_cast<int>(std::lround(2.0 * density.decades)) * density.points_per_decade;
  for (int i = 0; i <= steps; ++i) {
    points.push_back(value * std::pow(10.0, static_cast<double>(i) / density.points_per_decade - density.decades));
  }
}

// Intervals may be narrow and begin at another input, for example K_n just above K_st.
void addPointsNear(std::vector<double>& points, double value, const ScanDensity& density) {
  for (int i = 1; i <= 6 * density.near_points_per_decade; ++i) {
    const double distance = std::pow(10.0, -static_cast<double>(i) / density.near_points_per_decade);
    points.push_back(value * (1.0 + distance));
    points.push_back(value * (1.0 - distance));
  }
}

std::vector<double> scanPoints(const Specification& specification, const element::ParameterInfo& input,
                               const ScanDensity& density) {
  std::vector<double> points;
  if (isCount(input)) {
    for (double count = input.range.lower; count <= input.range.upper; count += 1.0) {
      points.push_back(count);
    }
    return points;
  }
  addScanPoints(points, specification.at(input.name), density);
  for (const element::ParameterInfo& other : specificationParameters()) {
    if (other.unit == input.unit && specification.has(other.name)) {
      addPointsNear(points, specification.at(other.name), density);
    }
  }
  points.erase(std::remove_if(points.begin(), points.end(), [&](double x) { return !input.range.contains(x); }),
               points.end());
  std::sort(points.begin(), points.end());
  return points;
}

// Returns the limit between a value without a solution and a value with one.
double edge(double without, double with, const std::function<bool(double)>& solvable, double tolerance) {
  constexpr int kMostHalvings = 200;  // ends the loop if there is no number between the limits
  for (int i = 0; i < kMostHalvings && std::abs(with - without) > tolerance * std::abs(with); ++i) {
    const double middle = 0.5 * (without + with);
    (solvable(middle) ? with : without) = middle;
  }
  return with;
}

// Describes intervals in the unit that the user wrote.
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

// Returns a value with few digits inside an interval, near one of its limits.
double roundedInside(const element::Range& interval, double end) {
  constexpr double kInside = 0.01;
  const double width = std::min(interval.upper - interval.lower, std::abs(end));
  const double value = end + (end == interval.lower ? kInside : -kInside) * width;
  const double unit = std::pow(10.0, std::floor(std::log10(0.5 * kInside * width)));
  return std::round(value / unit) * unit;
}

// The specification with a solution that is nearest to the given one.
class Nearest {
 public:
  explicit Nearest(const Solvable& solvable) : solvable_(solvable) {}

  /// Offers a specification with one input moved into `intervals`. `before`: distance of earlier moves of other inputs.
  void offer(const Specification& specification, const element::ParameterInfo& input,
             const std::vector<element::Range>& intervals, double before = 0.0) {
    const double given = specification.at(input.name);
    for (const element::Range& interval : intervals) {
      const double end = given < interval.lower ? interval.lower : interval.upper;
      const double distance = before + std::abs(std::log(end / given));
      if (distance < distance_) {
        offer(specification, input.name, isCount(input) ? end : roundedInside(interval, end), distance);
      }
    }
  }

  bool found() const { return std::isfinite(distance_); }

  std::string text() const { return found() ? "; nearest: specification: {" + flowMap(nearest_) + "}" : ""; }

 private:
  void offer(Specification changed, const std::string& name, double value, double distance) {
    changed.set(name, value);
    if (solvable_(changed)) {
      nearest_ = changed;
      distance_ = distance;
    }
  }

  const Solvable& solvable_;
  Specification nearest_;
  double distance_ = std::numeric_limits<double>::infinity();
};

// Returns the inputs that a search may change. Displacements that may be 0 are excluded.
std::vector<element::ParameterInfo> searchedInputs(const Specification& specification) {
  return element::those(specificationParameters(), [&](const element::ParameterInfo& input) {
    return specification.has(input.name) && input.range.lower >= 0.0;
  });
}

// Offers changes of each other input after `first` was multiplied by a factor.
void moveBeside(const element::ParameterInfo& first, double factor, const Specification& specification,
                const Solvable& solvable, Nearest& nearest) {
  Specification moved = specification;
  moved.set(first.name, specification.at(first.name) * factor);
  for (const element::ParameterInfo& second : searchedInputs(specification)) {
    if (second.name != first.name && first.range.contains(moved.at(first.name))) {
      nearest.offer(moved, second, solvableIntervals(moved, second, solvable, Scan::coarse),
                    std::abs(std::log(factor)));
    }
  }
}

// Changes two inputs, the first by as little as possible, if no single input helps.
void moveTwo(const Specification& specification, const Solvable& solvable, Nearest& nearest) {
  for (const double by : {0.02, 0.1, 0.3, 0.7}) {
    for (const element::ParameterInfo& first : searchedInputs(specification)) {
      if (!isCount(first)) {
        moveBeside(first, 1.0 + by, specification, solvable, nearest);
        moveBeside(first, 1.0 - by, specification, solvable, nearest);
      }
    }
    if (nearest.found()) {
      return;
    }
  }
}

}  // namespace

std::string flowMap(const Specification& specification) {
  std::string text;
  for (const element::ParameterInfo& input : specificationParameters()) {
    if (specification.has(input.name)) {
      text += (text.empty() ? "" : ", ") + inputText(specification, input.name);
    }
  }
  return text;
}

std::vector<element::Range> solvableIntervals(const Specification& specification, const element::ParameterInfo& input,
                                              const Solvable& solvable, Scan scan) {
  const ScanDensity density = densityOf(scan);
  const auto withValue = [&](double value) {
    Specification changed = specification;
    changed.set(input.name, value);
    return solvable(changed);
  };
  const std::vector<double> points = scanPoints(specification, input, density);
  std::vector<element::Range> intervals;
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (withValue(points[i])) {
      if (!inside) {
        const double lower = isCount(input) ? points[i]
                             : i == 0       ? input.range.lower
                                            : edge(points[i - 1], points[i], withValue, density.tolerance);
        intervals.push_back(isCount(input) ? element::Range::closed(lower, lower)
                                           : element::Range::open(lower, input.range.upper));
      } else if (isCount(input)) {
        intervals.back().upper = points[i];
      }
      inside = true;
    } else if (inside) {
      if (!isCount(input)) {
        intervals.back().upper = edge(points[i], points[i - 1], withValue, density.tolerance);
      }
      inside = false;
    }
  }
  return intervals;
}

std::string describeSolvableInputs(const Specification& specification, const Solvable& solvable, Scan scan) {
  std::string text;
  Nearest nearest(solvable);
  for (const element::ParameterInfo& input : searchedInputs(specification)) {
    const std::vector<element::Range> intervals = solvableIntervals(specification, input, solvable, scan);
    if (!intervals.empty()) {
      text += (text.empty() ? "" : "; ") + describe(intervals, input, specification.writtenUnit(input.name));
      nearest.offer(specification, input, intervals);
    }
  }
  if (text.empty() && scan == Scan::fine) {
    moveTwo(specification, solvable, nearest);
  }
  return (text.empty() ? "no value of any single input with the others unchanged"
                       : text + " (each with the others unchanged)") +
         nearest.text();
}

}  // namespace rubber_suspension::estimation
