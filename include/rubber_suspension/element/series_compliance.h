// Mount that yields in series with the specimen: bracket, rig frame, adapter.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension {

/// 1/K*_measured = 1/K* + 1/K_s: lowers stiffness and loss angle, alike at all frequencies.
/// The component solves for the displacement of the specimen at each step. Several mounts add their compliances.
class SeriesCompliance final : public SeriesElement {
 public:
  explicit SeriesCompliance(double stiffness /* K_s [N/m] */) : stiffness_(stiffness) {}
  double stiffness() const override { return stiffness_; }

 private:
  double stiffness_;
};

ElementType seriesComplianceType();

}  // namespace rubber_suspension
