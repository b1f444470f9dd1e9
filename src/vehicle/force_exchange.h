// How a vehicle that steps at fixed times gets the forces of its components: from the library, or from elsewhere.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "rubber_suspension/component/pose_stream.h"
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

/// Motions go out, loads come back, one of each component; several may be under way.
template <class Motions, class Loads>
class Exchange {
 public:
  virtual ~Exchange() = default;

  /// Send the motions at a stamp [ns].
  virtual void send(std::int64_t stamp, const Motions& motions) = 0;

  /// Wait for the loads that answer the motions sent at a stamp. Throws std::runtime_error where none come.
  virtual Loads receive(std::int64_t stamp) = 0;
};

/// Displacements [m] and forces [N]; poses of B in A and wrenches on B.
using ForceExchange = Exchange<PerStrut, PerStrut>;
using WrenchExchange = Exchange<PerBush<Eigen::Isometry3d>, PerBush<component::Wrench>>;

/// The library in the same process, by the same streams that the node feeds: the same numbers to the last bit.
template <class Stream, class Motions, class Loads>
class StreamExchange final : public Exchange<Motions, Loads> {
 public:
  /// The components, one per strut or bush, must outlive this object.
  template <class Component>
  explicit StreamExchange(const std::vector<Component>& components) : streams_(components.begin(), components.end()) {}

  void send(std::int64_t stamp, const Motions& motions) override;
  Loads receive(std::int64_t stamp) override;

 private:
  struct Answer {
    std::int64_t stamp;
    Loads loads;
  };

  std::vector<Stream> streams_;
  std::deque<Answer> answers_;
};

using LibraryExchange = StreamExchange<component::SampleStream, PerStrut, PerStrut>;
using LibraryWrenchExchange =
    StreamExchange<component::PoseStream, PerBush<Eigen::Isometry3d>, PerBush<component::Wrench>>;

}  // namespace rubber_suspension::vehicle
