// The steps of a fleet, for one kind of processor: the laws are those of Component::step. See instruction_sets.h.
#include "kernel/lanes.h"

// Some lanes of the rows of eight components, as many as a vector has.
class Group {
 public:
  Group(LaneRow* rows, std::size_t first_lane) : rows_(rows), first_lane_(first_lane) {}

  Lanes row(std::size_t row) const { return load(rows_[row].lane + first_lane_); }
  void set(std::size_t row, const Lanes& lanes) { store(lanes, rows_[row].lane + first_lane_); }
  Group maxwell(std::size_t k) const { return Group(rows_ + kFirstMaxwell + k * kMaxwellRows, first_lane_); }

  Lanes friction(const Lanes& displacement) const {
    return frictionBranch(displacement, row(kReferenceDisplacement), row(kReferenceForce), row(kMaximumForce),
                          row(kCompliance));
  }

  // Starts a branch at displacements, with the friction that there is, in the lanes of the mask.
  void startBranch(const LaneMask& mask, const Lanes& turning_point) {
    const Lanes force = limited(friction(turning_point), row(kMaximumForce));
    set(kReferenceForce, select(mask, force, row(kReferenceForce)));
    set(kReferenceDisplacement, select(mask, turning_point, row(kReferenceDisplacement)));
  }

 private:
  LaneRow* rows_;
  std::size_t first_lane_;
};

// BergFriction::turn for the lanes that do not go on along their branch.
inline void turn(Group& group, const Lanes& displacement, const Lanes& beyond) {
  const Lanes direction = group.row(kDirection);
  const Lanes extremum = group.row(kExtremum);
  const Lanes start = group.row(kReferenceDisplacement);
  const auto goes_on = beyond > 0.0;
  const auto starts = (direction == 0.0) & (displacement != start);
  const auto turns = -beyond > group.row(kDeadBand);
  group.startBranch(turns, extremum);
  const Lanes towards = select(displacement > start, spread(1.0), spread(-1.0));
  group.set(kDirection, select(starts, towards, select(turns, -direction, direction)));
  group.set(kExtremum, select(goes_on | starts | turns, displacement, extremum));
}

inline Lanes stepFriction(Group& group, const Lanes& displacement) {
  const Lanes beyond = (displacement - group.row(kExtremum)) * group.row(kDirection);
  if (all(beyond > 0.0)) {
    group.set(kExtremum, displacement);
  } else {
    turn(group, displacement, beyond);
  }
  return group.friction(displacement);
}

inline Lanes stepGroup(Group group, std::size_t maxwells, bool frictional, const Lanes& displacement) {
  const Lanes increment = displacement - group.row(kDisplacement);
  group.set(kDisplacement, displacement);
  Lanes viscous = group.row(kDashpot) * increment;
  for (std::size_t k = 0; k < maxwells; ++k) {
    Group maxwell = group.maxwell(k);
    const Lanes force = maxwell.row(kDecay) * maxwell.row(kForce) + maxwell.row(kGain) * increment;
    maxwell.set(kForce, force);
    viscous += force;
  }
  const Lanes friction = frictional ? stepFriction(group, displacement) : Lanes{};
  return group.row(kSpring) * displacement + viscous + friction;
}

// frictionBranch where all lanes have one way from the reference point, and keep to one side of it.
class Branch {
 public:
  Branch(const Group& group, double side)
      : reference_force_(group.row(kReferenceForce)),
        left_(side * group.row(kMaximumForce) - reference_force_),
        reach_(group.row(kCompliance) * magnitude(left_) + std::numeric_limits<double>::min()) {}

  Lanes force(double way) const { return reference_force_ + way * left_ / (reach_ + way); }

 private:
  Lanes reference_force_;
  Lanes left_;
  Lanes reach_;
};

// All numbers of a group in registers.
template <std::size_t maxwells, bool frictional>
inline void simulateGroup(Group group, const LogBlock& block, double* force, std::size_t stride) {
  Lanes decay[maxwells + 1];
  Lanes gain[maxwells + 1];
  Lanes memory[maxwells + 1];
  for (std::size_t k = 0; k < maxwells; ++k) {
    decay[k] = group.maxwell(k).row(kDecay);
    gain[k] = group.maxwell(k).row(kGain);
    memory[k] = group.maxwell(k).row(kForce);
  }
  const Lanes spring = group.row(kSpring);
  const Lanes dashpot = group.row(kDashpot);
  std::size_t sample = 0;
  for (const Stretch* stretch = block.stretch; sample < block.size; ++stretch) {
    if (stretch->turns) {
      group.startBranch(~LaneMask{}, spread(stretch->turning_point));
    }
    const Branch branch(group, stretch->side);
    for (; sample < stretch->end; ++sample) {
      const double increment = block.increment[sample];
      Lanes viscous = dashpot * increment;
      for (std::size_t k = 0; k < maxwells; ++k) {
        memory[k] = decay[k] * memory[k] + gain[k] * increment;
        viscous += memory[k];
      }
      const Lanes friction = frictional ? branch.force(block.way[sample]) : Lanes{};
      store(spring * block.displacement[sample] + viscous + friction, force + sample * stride);
    }
  }
  for (std::size_t k = 0; k < maxwells; ++k) {
    group.maxwell(k).set(kForce, memory[k]);
  }
  group.set(kDisplacement, spread(block.displacement[block.size - 1]));
  group.set(kExtremum, spread(block.extremum));
  group.set(kDirection, spread(block.direction));
}

template <std::size_t maxwells>
inline void simulateGroup(bool frictional, Group group, const LogBlock& block, double* force, std::size_t stride) {
  return frictional ? simulateGroup<maxwells, true>(group, block, force, stride)
                    : simulateGroup<maxwells, false>(group, block, force, stride);
}

inline void simulateGroup(std::size_t maxwells, bool frictional, Group group, const LogBlock& block, double* force,
                          std::size_t stride) {
  switch (maxwells) {
    case 0:
      return simulateGroup<0>(frictional, group, block, force, stride);
    case 1:
      return simulateGroup<1>(frictional, group, block, force, stride);
    case 2:
      return simulateGroup<2>(frictional, group, block, force, stride);
    case 3:
      return simulateGroup<3>(frictional, group, block, force, stride);
    case 4:
      return simulateGroup<4>(frictional, group, block, force, stride);
    case 5:
      return simulateGroup<5>(frictional, group, block, force, stride);
    case 6:
      return simulateGroup<6>(frictional, group, block, force, stride);
    case 7:
      return simulateGroup<7>(frictional, group, block, force, stride);
    default:
      return simulateGroup<kMostMaxwells>(frictional, group, block, force, stride);
  }
}

/// One step of each group; displacement [m] and force [N] have eight numbers for each.
void stepGroups(const FleetGroups& groups, const double* displacement, double* force) {
  for (std::size_t i = 0; i < groups.count; ++i) {
    for (std::size_t lane = 0; lane < kLanes; lane += kWidth) {
      const Group group(groups.first + i * groups.rows, lane);
      const std::size_t place = i * kLanes + lane;
      store(stepGroup(group, groups.maxwells, groups.frictional, load(displacement + place)), force + place);
    }
  }
}

/// A block of a log; `stride` is the distance of the forces [N] of one sample to those of the next.
void simulateGroups(const FleetGroups& groups, const LogBlock& block, double* force, std::size_t stride) {
  for (std::size_t i = 0; i < groups.count; ++i) {
    for (std::size_t lane = 0; lane < kLanes; lane += kWidth) {
      const Group group(groups.first + i * groups.rows, lane);
      simulateGroup(groups.maxwells, groups.frictional, group, block, force + i * kLanes + lane, stride);
    }
  }
}
