// Table of the admissible values of parameters, for checks, errors and reference pages.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rubber_suspension::element {

/// An interval of admissible values; an open end excludes its bound.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool open_lower = false;
  bool open_upper = false;

  bool contains(double value) const;

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true, false}; }
  static Range nonNegative() { return {0.0, std::numeric_limits<double>::infinity(), false, false}; }
  static Range closed(double lower, double upper) { return {lower, upper, false, false}; }
  static Range openBelow(double lower, double upper) { return {lower, upper, true, false}; }
  static Range openAbove(double lower, double upper) { return {lower, upper, false, true}; }
  static Range open(double lower, double upper) { return {lower, upper, true, true}; }
};

/// Returns text such as "greater than 0" or "in [0, 1)", for the accepted values in an error message.
std::string describe(const Range& range);

/// The effect of a parameter on the force, which determines whether it is fitted.
enum class Role {
  scale,      ///< the force is linear in the parameter while the others are constant: fitted by linear least squares
  shape,      ///< the force depends on the parameter in another way: fitted
  choice,     ///< a count, a switch, a dead band, the span or the points over which a law is realised: never fitted
  reference,  ///< the point to which another value refers; a fit varies that other value instead
};

/// Returns the word for the reference page.
std::string toString(Role role);

/// One row of a table of parameters.
struct ParameterInfo {
  std::string name;           ///< the YAML key
  std::string unit;           ///< SI unit in UDUNITS spelling, "1" for none; fixes the dimension
  Role role;                  ///< effect on the force
  Range range;                ///< admissible values, in that unit
  std::string documentation;  ///< a sentence for the reference page and for errors
  std::optional<double> default_value = std::nullopt;  ///< absent: the parameter is required
  bool is_list = false;                                ///< true: the value is a list of numbers
};

/// Returns the row of that name, or nullptr if there is none.
const ParameterInfo* findParameter(const std::vector<ParameterInfo>& table, std::string_view name);

/// Returns true if `estimate --from-log` and `diagnose` fit a parameter that has these values. They fit a scale or a
/// shape with one value, unless this value is 0 or an end of the range, where the law lacks an effect (a stop is
/// linear). They do not fit lists of several numbers, because these are curves that were measured point by point.
bool isFree(const ParameterInfo& parameter, const std::vector<double>& values);

/// Values by parameter name; a scalar is a list of one value.
using ParameterValues = std::map<std::string, std::vector<double>>;

/// An entry of `elements:` or `add:`: the name of a law and the values of its parameters [SI].
struct ElementDescription {
  std::string type;
  ParameterValues values;
  bool of_rig = false;  ///< the component file marks it as part of the rig

  /// Returns the scalar parameter of that name. Throws std::out_of_range if it is missing.
  double value(const std::string& name) const { return list(name).at(0); }

  /// Returns all values of the parameter of that name. Throws std::out_of_range if it is missing.
  const std::vector<double>& list(const std::string& name) const {
    const auto found = values.find(name);
    return found != values.end() ? found->second : throw std::out_of_range(name);
  }

  bool operator==(const ElementDescription& other) const {
    return type == other.type && values == other.values && of_rig == other.of_rig;
  }
  bool operator!=(const ElementDescription& other) const { return !(*this == other); }
};

/// Throws std::invalid_argument with the message that all errors about a value have: law, parameter, value, accepted
/// values.
[[noreturn]] void refuseValue(const std::string& type, const std::string& parameter, double value,
                              const std::string& unit, const std::string& accepted);

/// Returns the parameter `side` of a law that may act on one side only: 1, -1 or, if `may_be_both`, 0 for both. Throws
/// std::invalid_argument for any other value; `quantity` is the signal whose sign determines the side.
int sideOf(const ElementDescription& description, const char* quantity, bool may_be_both = true);

}  // namespace rubber_suspension::element
