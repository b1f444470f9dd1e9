// Fuzz target: a message of any bytes that passes the node's check can be decoded to its last byte, and encodes to the
// same bytes. The first byte selects the type of the message.
#include <ros/serialization.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/MeasuredForce.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "node/message_bounds.h"

namespace {

constexpr std::size_t kComponents = 5;

template <class Message>
void decode(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes(data, data + size);  // a copy, so that reading beyond its end is detected
  Message message;
  ros::serialization::IStream input(bytes.data(), static_cast<std::uint32_t>(size));
  ros::serialization::deserialize(input, message);
  std::vector<std::uint8_t> again(size);
  if (input.getLength() != 0 || ros::serialization::serializationLength(message) != size) {
    std::abort();
  }
  ros::serialization::OStream output(again.data(), static_cast<std::uint32_t>(size));
  ros::serialization::serialize(output, message);
  if (again != bytes) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rubber_suspension;
  if (size == 0) {
    return 0;
  }
  const std::uint8_t kind = data[0] % 3;
  ++data;
  --size;
  if (kind == 0 && node::isStamped<1>(data, size)) {
    decode<Displacement>(data, size);
  } else if (kind == 1 && node::isStamped<1>(data, size)) {
    decode<MeasuredForce>(data, size);
  } else if (kind == 2 && node::isBundle(data, size, kComponents)) {
    decode<DisplacementArray>(data, size);
  }
  return 0;
}
