// The parameters that a model already has, as unknowns of a fit.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {

/// Which numbers count as the model's own.
enum class Level {
  specification,  ///< those that the user wrote: K_st, K_n, K_max, f_h, ...; of a list of elements, all parameters
  elements,       ///< those of the estimated elements: every stiffness, every break frequency
};

/// A model's own parameters as logarithms of their ratios to the configured values, so that 0 is "as configured".
/// The point of operation (nominal frequency and amplitude) and counts are not unknowns.
class OwnParameters {
 public:
  OwnParameters(const ComponentDescription& description, Level level);

  Eigen::Index size() const { return static_cast<Eigen::Index>(names_.size()); }
  const std::vector<std::string>& names() const { return names_; }

  /// The bound on |logarithm|: a value that is off by more than this factor is another component.
  static double bound();

  /// The component with these logarithms of ratios.
  ComponentDescription apply(const Eigen::VectorXd& logarithms) const;

  /// Its elements; nothing where the specification has no solution or an element refuses its parameters.
  std::optional<std::vector<ElementDescription>> elements(const Eigen::VectorXd& logarithms) const;

 private:
  struct Slot {
    enum { specification, element, added } where;
    std::size_t entry;
    std::string key;
    std::size_t position;
  };

  void addElements(const std::vector<ElementDescription>& elements, decltype(Slot::where) where);

  ComponentDescription description_;
  std::vector<Slot> slots_;
  std::vector<std::string> names_;
};

}  // namespace rubber_suspension
