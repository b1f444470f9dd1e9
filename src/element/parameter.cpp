// Ranges of parameters, their text, and errors about values.
#include "rubber_suspension/element/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "element/largest_number.h"

namespace rubber_suspension::element {
namespace {

bool isTooSmall(double value, const Range& range) {
  return range.lower >= 0.0 && value > 0.0 && value < kSmallestNumber;
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = open_lower ? value > lower : value >= lower;
  const bool below = open_upper ? value < upper : value <= upper;
  return std::abs(value) <= kLargestNumber && !isTooSmall(value, *this) && above && below;
}

std::string acceptedFor(double value, const Range& range) {
  const std::string accepted = describe(range);
  return std::abs(value) > kLargestNumber ? fmt::format("{}, at most {:g}", accepted, kLargestNumber)
         : isTooSmall(value, range)       ? fmt::format("{}, at least {:g}", accepted, kSmallestNumber)
                                          : accepted;
}

std::string describe(const Range& range) {
  const bool bounded_below = std::isfinite(range.lower);
  const bool bounded_above = std::isfinite(range.upper);
  if (bounded_below && bounded_above) {
    return fmt::format("in {}{:g}, {:g}{}", range.open_lower ? "(" : "[", range.lower, range.upper,
                       range.open_upper ? ")" : "]");
  }
  if (bounded_below) {
    return fmt::format("{} {:g}", range.open_lower ? "greater than" : "at least", range.lower);
  }
  if (bounded_above) {
    return fmt::format("{} {:g}", range.open_upper ? "less than" : "at most", range.upper);
  }
  return "any finite number";
}

std::string toString(Role role) {
  static const char* const words[] = {"scale", "shape", "choice", "reference"};
  return words[static_cast<std::size_t>(role)];
}

const ParameterInfo* findParameter(const std::vector<ParameterInfo>& table, std::string_view name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const ParameterInfo& parameter) { return parameter.name == name; });
  return found == table.end() ? nullptr : &*found;
}

bool isFree(const ParameterInfo& parameter, const std::vector<double>& values) {
  if (values.size() != 1 || (parameter.role != Role::scale && parameter.role != Role::shape)) {
    return false;
  }
  const double value = values.front();
  return value != 0.0 && value != parameter.range.lower && value != parameter.range.upper;
}

void refuseValue(const std::string& type, const std::string& parameter, double value, const std::string& unit,
                 const std::string& accepted) {
  throw ValueOutOfRange(fmt::format("{}.{}: {:g}{} is out of range; accepted: {}", type, parameter, value,
                                    unit == "1" ? "" : " " + unit, accepted));
}

int sideOf(const ElementDescription& description, const char* quantity, bool may_be_both) {
  const double side = description.value("side");
  if (std::abs(side) != 1.0 && !(may_be_both && side == 0.0)) {
    refuseValue(description.type, "side", side, "1",
                fmt::format(may_be_both ? "1 ({0} > 0 only), -1 ({0} < 0 only) or 0 (both)"
                                        : "1 ({0} > 0 only) or -1 ({0} < 0 only)",
                            quantity));
  }
  return static_cast<int>(side);
}

}  // namespace rubber_suspension::element
