// Compliances and contacts in series with the test piece, and the resulting displacement. No function here throws.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/kernel/basic_laws_kernel.h"

namespace rubber_suspension::component {

/// Series elements, whose deflections under the common force F add up to u(F). The displacement of the test piece is
/// the solution of the series balance z_test_piece + u(F) = z.
class SeriesBalance {
 public:
  void add(const std::shared_ptr<const element::SeriesElement>& element);

  bool empty() const { return empty_; }

  /// Returns true if u = F/K_s with the same stiffness K_s for both signs of the force.
  bool linear() const { return hardening_.empty() && sides_.tension == sides_.compression && !hasContact(); }

  /// Returns true if a contact opens under a force of either sign.
  bool hasContact() const { return tension_opens_ < kNever || compression_opens_ < kNever; }

  /// Returns true if a contact opens under this force [N].
  bool opensUnder(double force) const { return force > tension_opens_ || -force > compression_opens_; }

  /// Returns the force [N] that an open contact transmits, with the sign of the force that opens it.
  double keptBy(double force) const { return force > tension_opens_ ? tension_opens_ : -compression_opens_; }

  /// Returns 1/K_s [m/N] of a linear balance; 0 if there are no elements.
  double compliance() const { return sides_.tension; }

  /// Returns the deflection u [m] under a force [N], not counting open contacts.
  double deflection(double force) const;

  /// Returns the displacement [m] of a test piece that consists of basic laws only, at the end of a step. `path`:
  /// motion before the compliance; `start`: displacement [m] of the test piece before the step; `memory` and
  /// `prepared`: data of the kernel. The solution is in closed form if no element hardens and if there is at most one
  /// friction, which keeps its direction. No contact may open.
  double solve(const kernel::BasicLawsKernel& laws, const element::Motion& path, double start, const double* memory,
               const kernel::PreparedStep& prepared) const {
    // The part that is linear in the displacement is computed once, and not in each trial.
    const kernel::LinearForce linear = laws.withoutFriction(start, memory, prepared);
    if (hardening_.empty()) {
      const Equation equation = equationOf(laws, linear, path, memory);
      if (const auto z = laws.balance(equation.slope, equation.offset, equation.compliance, memory)) {
        return *z;
      }
    }
    return search(laws, linear, path, start, memory);
  }

 private:
  /// Coefficients of slope z + offset + compliance friction(z) = 0, which is the balance if no element hardens.
  struct Equation {
    double slope;       // [-]
    double offset;      // [m]
    double compliance;  // compliance for the sign of the force [m/N]
  };

  Equation equationOf(const kernel::BasicLawsKernel& laws, const kernel::LinearForce& linear,
                      const element::Motion& path, const double* memory) const {
    // The compliance does not change the sign of the force, so that the force without compliance determines the side.
    const double compliance =
        sides_.tension == sides_.compression
            ? sides_.tension
            : sideCompliance(linear.at(path.displacement) + laws.frictionAt(path.displacement, memory));
    return {1.0 + compliance * linear.slope, compliance * linear.held - path.displacement, compliance};
  }

  double search(const kernel::BasicLawsKernel& laws, const kernel::LinearForce& linear, const element::Motion& path,
                double start, const double* memory) const;

  double sideCompliance(double force) const { return force > 0.0 ? sides_.tension : sides_.compression; }

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  bool empty_ = true;
  double tension_opens_ = kNever;      // tensile force beyond which a contact opens [N]
  double compression_opens_ = kNever;  // magnitude of the compressive force beyond which a contact opens [N]
  element::SeriesElement::Compliance sides_{0.0, 0.0};  // sums over the elements that are linear on each side
  std::vector<std::shared_ptr<const element::SeriesElement>> hardening_;  // elements that harden
};

}  // namespace rubber_suspension::component
