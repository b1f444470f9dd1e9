// Compliances and contacts in series with the test piece, and its remaining displacement. Throws nothing.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/kernel/basic_laws_kernel.h"

namespace rubber_suspension::component {

/// Elements of series compliance, whose deflections under the common force F add up: z_test_piece + u(F) = z. The
/// solution of this series balance is the displacement of the test piece.
class SeriesBalance {
 public:
  void add(const std::shared_ptr<const element::SeriesElement>& element);

  bool empty() const { return empty_; }

  /// Returns true if u = F/K_s on both sides.
  bool linear() const { return hardening_.empty() && sides_.tension == sides_.compression && !hasContact(); }

  /// Returns true if a contact opens under a force of some sign.
  bool hasContact() const { return tension_opens_ < kNever || compression_opens_ < kNever; }

  /// Returns true if a contact opens under this force [N].
  bool opensUnder(double force) const { return force > tension_opens_ || -force > compression_opens_; }

  /// Returns the force [N] that an open contact transmits, with the sign of the force that opens it.
  double keptBy(double force) const { return force > tension_opens_ ? tension_opens_ : -compression_opens_; }

  /// Returns 1/K_s [m/N] of a linear balance; 0 without elements.
  double compliance() const { return sides_.tension; }

  /// Returns the deflection u [m] under a force [N], except that of open contacts.
  double deflection(double force) const;

  /// Returns the displacement [m] of a test piece of basic laws alone at the end of a step. `path`: motion before the
  /// compliance; `start`: displacement [m] of the test piece before the step; `memory` and `prepared`: those of the
  /// kernel. In closed form if nothing hardens and a single friction, if any, keeps its direction. Contacts must not
  /// open.
  double solve(const kernel::BasicLawsKernel& laws, const element::Motion& path, double start, const double* memory,
               const kernel::PreparedStep& prepared) const {
    // The part linear in the displacement is summed up once, not for each trial.
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
  /// The balance slope z + offset + compliance friction(z) = 0, which applies if no element hardens.
  struct Equation {
    double slope;       // [-]
    double offset;      // [m]
    double compliance;  // for the sign of the force [m/N]
  };

  Equation equationOf(const kernel::BasicLawsKernel& laws, const kernel::LinearForce& linear,
                      const element::Motion& path, const double* memory) const {
    // The compliance reduces the force but keeps its sign, which determines the side.
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
  double tension_opens_ = kNever;                       // of a contact, which opens beyond this force [N]
  double compression_opens_ = kNever;                   // likewise, beyond this magnitude
  element::SeriesElement::Compliance sides_{0.0, 0.0};  // sums over the elements that are linear to either side
  std::vector<std::shared_ptr<const element::SeriesElement>> hardening_;  // the others
};

}  // namespace rubber_suspension::component
