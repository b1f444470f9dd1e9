// Mount that yields in series with the specimen.
#include "rubber_suspension/element/series_compliance.h"

namespace rubber_suspension {

ElementType seriesComplianceType() {
  return {"series_compliance",
          "Bracket or rig that yields in series with the specimen.",
          {{"stiffness", "N/m", Range::positive(), std::nullopt, "stiffness K_s of what is in series"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const SeriesCompliance>(description.value("stiffness"));
          }};
}

}  // namespace rubber_suspension
