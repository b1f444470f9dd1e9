// A quantity that depends on the displacement: linear between points, constant outside them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// Interpolates a quantity between points of the displacement. Two points at one displacement form a step, at which the
/// later point gives the value.
class PositionTable {
 public:
  /// Throws std::invalid_argument, which names law and parameter, for empty lists, lists of different lengths and
  /// decreasing displacements.
  PositionTable(const std::string& type, std::vector<double> displacement /* [m] */, const std::string& name,
                std::vector<double> value)
      : displacement_(std::move(displacement)), value_(std::move(value)) {
    if (displacement_.empty() || displacement_.size() != value_.size()) {
      throw std::invalid_argument(
          fmt::format("{}.{}: has {} values for {} displacements; accepted: one value for each displacement", type,
                      name, value_.size(), displacement_.size()));
    }
    for (std::size_t i = 1; i < displacement_.size(); ++i) {
      if (!(displacement_[i] >= displacement_[i - 1])) {
        refuseValue(type, "displacement", displacement_[i], "m",
                    fmt::format("at least {:g}, which is the preceding value", displacement_[i - 1]));
      }
    }
  }

  double at(double displacement) const {
    return inPiece(static_cast<std::size_t>(std::upper_bound(displacement_.begin(), displacement_.end(), displacement) -
                                            displacement_.begin()),
                   displacement);
  }

  /// Calls `visit` for each linear piece of the path from `begin` to `end`, in order. Its arguments are the ends of the
  /// piece [m] and the values there.
  template <class Visit>
  void along(double begin, double end, Visit visit) const {
    begin < end ? upwards(begin, end, visit) : downwards(begin, end, visit);
  }

 private:
  /// Returns the value in piece i, which lies below point i and above point i - 1.
  double inPiece(std::size_t i, double z) const {
    if (i == 0) {
      return value_.front();
    }
    if (i == value_.size()) {
      return value_.back();
    }
    const double share = (z - displacement_[i - 1]) / (displacement_[i] - displacement_[i - 1]);
    return value_[i - 1] + share * (value_[i] - value_[i - 1]);
  }

  template <class Visit>
  void upwards(double z, double end, Visit visit) const {
    auto i = static_cast<std::size_t>(std::upper_bound(displacement_.begin(), displacement_.end(), z) -
                                      displacement_.begin());
    for (; z < end; ++i) {
      const double next = i < displacement_.size() ? std::min(end, displacement_[i]) : end;
      if (next > z) {
        visit(z, next, inPiece(i, z), inPiece(i, next));
      }
      z = next;
    }
  }

  template <class Visit>
  void downwards(double z, double end, Visit visit) const {
    auto i = static_cast<std::size_t>(std::lower_bound(displacement_.begin(), displacement_.end(), z) -
                                      displacement_.begin());
    for (; z > end; --i) {
      const double next = i > 0 ? std::max(end, displacement_[i - 1]) : end;
      if (next < z) {
        visit(z, next, inPiece(i, z), inPiece(i, next));
      }
      z = next;
    }
  }

  std::vector<double> displacement_;
  std::vector<double> value_;
};

}  // namespace rubber_suspension::element
