// Several laws of stress softening that act in series, computed together in vector lanes.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::kernel {

/// Parameters of several laws (element/stress_softening.cpp), one law in each lane; 0 in unused lanes.
struct SofteningBlock {
  static constexpr std::size_t kSize = 8;
  using Numbers = std::array<double, kSize>;

  Numbers reduction{};                               ///< R/tanh(1/w) of the reduction R and the width w [-]
  Numbers steepness{};                               ///< 2/w of the width w [-]
  Numbers by_ratio{}, by_square{};                   ///< factors of the powers of |z|/S, one of which is 1
  Numbers evenly{}, by_reach{}, by_reach_squared{};  ///< factors of the powers of S/S_f, one of which is 1
  Numbers inverse_full_reach{};                      ///< 1/S_f of the reach S_f with full reduction [1/m]
  Numbers side{};                                    ///< -1: compression, 0: both sides, 1: tension
  Numbers inverse_path{};                            ///< 1/L of the path length L [1/m]
  Numbers recovery_rate{};                           ///< 1/T of the recovery time T [1/s]
  bool recovers = false;                             ///< true if any of the laws recovers
};

/// Product of the factors of several laws, equal to the product of their single factors up to rounding. The memory
/// contains the memories of all laws in order.
class SofteningBank final : public element::ForceEffect {
 public:
  /// Returns true if the bank supports a law with complete parameters, whose powers then need no std::pow.
  static bool takes(const element::ElementDescription& law);

  /// Adds a law. `description`: its parameters.
  void add(const element::ElementDescription& description, std::shared_ptr<const element::ForceEffect> law);

  std::size_t memorySize() const override { return kSlots * laws_.size(); }
  bool acceptsMemory(const double* memory) const override;
  void initialise(double displacement, double* memory) const override;
  double relax(double displacement, double* memory) const override;
  double step(const element::Motion& motion, const element::ComponentForce& force, double* memory) const override;

 private:
  static constexpr std::size_t kSlots = 2;  // memory of each law: largest displacement M, softened reach S

  std::vector<std::shared_ptr<const element::ForceEffect>> laws_;
  std::vector<SofteningBlock> blocks_;
};

}  // namespace rubber_suspension::kernel
