// How a vehicle that steps at fixed times gets the forces of its components: from the library, or from elsewhere.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "rubber_suspension/component/sample_stream.h"
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

/// Displacements go out, forces come back; several may be under way.
class ForceExchange {
 public:
  virtual ~ForceExchange() = default;

  /// Send the displacements [m] at a stamp [ns].
  virtual void send(std::int64_t stamp, const PerStrut& displacement) = 0;

  /// Wait for the forces [N] that answer the displacements sent at a stamp. Throws std::runtime_error where none come.
  virtual PerStrut receive(std::int64_t stamp) = 0;
};

/// The library in the same process, by the same streams that the node feeds: the same numbers to the last bit.
class LibraryExchange final : public ForceExchange {
 public:
  /// The components, one per strut, must outlive this object.
  explicit LibraryExchange(const std::vector<component::Component>& components);

  void send(std::int64_t stamp, const PerStrut& displacement) override;
  PerStrut receive(std::int64_t stamp) override;

 private:
  struct Answer {
    std::int64_t stamp;
    PerStrut force;
  };

  std::vector<component::SampleStream> streams_;
  std::deque<Answer> answers_;
};

}  // namespace rubber_suspension::vehicle
