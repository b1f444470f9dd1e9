// The list of all laws and the check of an entry against its table.
#include "rubber_suspension/element/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "element/suggestion.h"
#include "rubber_suspension/element/along_curve.h"
#include "rubber_suspension/element/arrhenius_shift.h"
#include "rubber_suspension/element/asymmetric_stiffness.h"
#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/bouc_wen.h"
#include "rubber_suspension/element/bump_stop.h"
#include "rubber_suspension/element/coulomb_friction.h"
#include "rubber_suspension/element/creep.h"
#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/first_loading.h"
#include "rubber_suspension/element/force_drift.h"
#include "rubber_suspension/element/force_offset.h"
#include "rubber_suspension/element/free_play.h"
#include "rubber_suspension/element/friction_behind_play.h"
#include "rubber_suspension/element/inertia.h"
#include "rubber_suspension/element/inertia_track.h"
#include "rubber_suspension/element/iwan.h"
#include "rubber_suspension/element/lift_off.h"
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/element/maxwell_behind_play.h"
#include "rubber_suspension/element/nonlinear_maxwell.h"
#include "rubber_suspension/element/overstress.h"
#include "rubber_suspension/element/position_dashpot.h"
#include "rubber_suspension/element/power_dashpot.h"
#include "rubber_suspension/element/power_dashpot_behind_play.h"
#include "rubber_suspension/element/progressive_stiffness.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/element/residual.h"
#include "rubber_suspension/element/self_heating.h"
#include "rubber_suspension/element/sensor_gain.h"
#include "rubber_suspension/element/series_compliance.h"
#include "rubber_suspension/element/sliding_maxwell.h"
#include "rubber_suspension/element/spring.h"
#include "rubber_suspension/element/spring_table.h"
#include "rubber_suspension/element/springpot.h"
#include "rubber_suspension/element/stress_softening.h"
#include "rubber_suspension/element/thinning_dashpot.h"
#include "rubber_suspension/element/thixotropic_maxwell.h"
#include "rubber_suspension/element/time_delay.h"
#include "rubber_suspension/element/transition_shift.h"
#include "rubber_suspension/element/variable_friction.h"
#include "rubber_suspension/element/vertical_shift.h"
#include "rubber_suspension/element/viscoplastic_friction.h"
#include "rubber_suspension/element/wlf_shift.h"

namespace rubber_suspension::element {
namespace {

const ElementType& requireType(const std::string& name) {
  if (const ElementType* type = findElementType(name)) {
    return *type;
  }
  const std::vector<std::string> names = namesOf(elementTypes());
  throw std::invalid_argument(fmt::format("type: '{}' is not an element{}; accepted: {}", name, didYouMean(name, names),
                                          fmt::join(names, ", ")));
}

void checkValue(const ElementType& type, const ParameterInfo& parameter, const std::vector<double>& values) {
  if (!parameter.is_list && values.size() != 1) {
    throw std::invalid_argument(
        fmt::format("{}.{}: takes one number, not {}", type.name, parameter.name, values.size()));
  }
  for (const double value : values) {
    if (!parameter.range.contains(value)) {
      refuseValue(type.name, parameter.name, value, parameter.unit, describe(parameter.range));
    }
  }
}

}  // namespace

const std::vector<ElementType>& elementTypes() {
  static const std::vector<ElementType> types = {
      springType(),
      progressiveStiffnessType(),
      asymmetricStiffnessType(),
      radialStiffnessType(),
      springTableType(),
      bumpStopType(),
      dashpotType(),
      powerDashpotType(),
      thinningDashpotType(),
      positionDashpotType(),
      maxwellType(),
      nonlinearMaxwellType(),
      slidingMaxwellType(),
      thixotropicMaxwellType(),
      maxwellBehindPlayType(),
      powerDashpotBehindPlayType(),
      maxwellAlongCurveType(),
      dashpotAlongCurveType(),
      slidersAlongCurveType(),
      springpotType(),
      creepType(),
      inertiaTrackType(),
      bergFrictionType(),
      boucWenType(),
      coulombFrictionType(),
      iwanType(),
      iwanTableType(),
      variableFrictionType(),
      viscoplasticFrictionType(),
      overstressType(),
      frictionBehindPlayType(),
      firstLoadingType(),
      stressSofteningType(),
      selfHeatingType(),
      wlfShiftType(),
      arrheniusShiftType(),
      verticalShiftType(),
      transitionShiftType(),
      freePlayType(),
      seriesComplianceType(),
      liftOffType(),
      timeDelayType(),
      inertiaType(),
      sensorGainType(),
      forceOffsetType(),
      forceDriftType(),
      residualType(),
  };
  return types;
}

const ElementType* findElementType(const std::string& name) {
  const auto& types = elementTypes();
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const ElementType& type) { return type.name == name; });
  return found == types.end() ? nullptr : &*found;
}

ElementDescription complete(const ElementDescription& description) {
  const ElementType& type = requireType(description.type);
  for (const auto& [name, values] : description.values) {
    const ParameterInfo* parameter = findParameter(type.parameters, name);
    if (parameter == nullptr) {
      const std::vector<std::string> names = namesOf(type.parameters);
      throw std::invalid_argument(fmt::format("{}.{}: unknown key{}; accepted: {}", type.name, name,
                                              didYouMean(name, names), fmt::join(names, ", ")));
    }
    checkValue(type, *parameter, values);
  }
  ElementDescription result = description;
  for (const ParameterInfo& parameter : type.parameters) {
    if (result.values.count(parameter.name) != 0) {
      continue;
    }
    if (!parameter.default_value) {
      throw std::invalid_argument(fmt::format("{}.{} is missing; needed is {} [{}], {}", type.name, parameter.name,
                                              parameter.documentation, parameter.unit, describe(parameter.range)));
    }
    result.values[parameter.name] = {*parameter.default_value};
  }
  return result;
}

bool isOfRig(const ElementDescription& description) {
  return description.of_rig || lawOf(makeElement(description)).ofMeasuringChain();
}

ElementPointer makeElement(const ElementDescription& description) {
  const ElementDescription full = complete(description);
  return requireType(full.type).make(full);
}

}  // namespace rubber_suspension::element
