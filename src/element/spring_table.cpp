// Spring whose characteristic is given by points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

constexpr const char* kTableName = "spring_table";

// A table without the point (0, 0) passes through this point only up to the rounding error of the interpolation.
constexpr double kRelativeOffset = 1e-9;

void checkLengths(const std::vector<double>& displacement, const std::vector<double>& force) {
  if (displacement.size() < 2 || force.size() != displacement.size()) {
    throw std::invalid_argument(fmt::format(
        "{}.force: has {} values for {} displacements; accepted: one force for each of at least 2 displacements",
        kTableName, force.size(), displacement.size()));
  }
}

void checkOrder(const std::vector<double>& displacement, const std::vector<double>& force, bool monotone) {
  for (std::size_t i = 1; i < displacement.size(); ++i) {
    if (!(displacement[i] > displacement[i - 1])) {
      refuseValue(kTableName, "displacement", displacement[i], "m",
                  fmt::format("greater than {:g}, which is the preceding value", displacement[i - 1]));
    }
    if (monotone && !(force[i] >= force[i - 1])) {
      refuseValue(kTableName, "force", force[i], "N",
                  fmt::format("at least {:g}, which is the preceding value, or monotone: 0", force[i - 1]));
    }
  }
}

/// Simulates F(z) through the points (z_i, F_i), linear between them and with the slopes of the first and last piece
/// beyond. No loss. The displacements increase. If `monotone` is true, the forces must not decrease and F(0) must be 0;
/// a preload is then a `force_offset`. Otherwise any forces are accepted, such as absolute forces at absolute
/// displacements, and the law may not be passive. Validity: a quasi-static characteristic between the end points;
/// beyond them the table only extrapolates.
class SpringTable final : public ParallelElement {
 public:
  /// Throws std::invalid_argument if the lists break these rules.
  SpringTable(std::vector<double> displacement /* [m] */, std::vector<double> force /* [N] */, bool monotone)
      : displacement_(std::move(displacement)), force_(std::move(force)), monotone_(monotone) {
    checkLengths(displacement_, force_);
    checkOrder(displacement_, force_, monotone_);
    const double at_zero = this->force(0.0);
    if (monotone_ &&
        std::abs(at_zero) > kRelativeOffset * std::max(std::abs(force_.front()), std::abs(force_.back()))) {
      refuseValue(kTableName, "force", at_zero, "N at displacement 0",
                  "0 N at displacement 0 (give a preload as force_offset), or monotone: 0");
    }
  }

  double force(double displacement) const {
    const auto after = std::upper_bound(displacement_.begin() + 1, displacement_.end() - 1, displacement);
    const auto i = static_cast<std::size_t>(after - displacement_.begin());
    const double slope = (force_[i] - force_[i - 1]) / (displacement_[i] - displacement_[i - 1]);
    return force_[i - 1] + slope * (displacement - displacement_[i - 1]);
  }

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }
  bool passive() const override { return monotone_; }

 private:
  std::vector<double> displacement_;
  std::vector<double> force_;
  bool monotone_;
};

const ElementEntry kSpringTableEntry(
    50,
    {kTableName,
     "Spring whose characteristic is given by points. It is linear between the points and continues with the end "
     "slopes beyond them.",
     {{"displacement", "m", Role::choice, Range::any(), "displacement of each point, increasing", std::nullopt, true},
      {"force", "N", Role::scale, Range::any(), "force at each point", std::nullopt, true},
      {"monotone", "1", Role::choice, Range::closed(0.0, 1.0),
       "1: the forces do not decrease and are 0 at displacement 0; 0: any forces", 1.0}},
     [](const ElementDescription& description) -> ElementPointer {
       return std::make_shared<const SpringTable>(description.list("displacement"), description.list("force"),
                                                  description.value("monotone") != 0.0);
     }});

}  // namespace
}  // namespace rubber_suspension::element
