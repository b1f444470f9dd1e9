// A saved state in bytes: a magic number, a checksum of what follows, and CBOR.
#include "fmi/runtime/saved_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "element/refuse.h"

template <>
struct nlohmann::adl_serializer<std::optional<double>> {
  static void to_json(json& value, const std::optional<double>& number) { value = number ? json(*number) : json(); }
  static void from_json(const json& value, std::optional<double>& number) {
    number = value.is_null() ? std::nullopt : std::make_optional(value.get<double>());
  }
};

namespace rubber_suspension::fmi {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Standing, phase, time, stop_time, inputs, outputs, derivative, temperature,
                                   parameters, settled)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SavedState, fingerprint, standing, component_displacement, memory)

namespace {

constexpr std::uint64_t kMagic = 0x3530544154535352;  // "RSSTAT05", lowest byte first
constexpr std::size_t kHead = 16;                     // bytes of magic number and checksum

// FNV-1a.
std::uint64_t hashOf(const char* bytes, std::size_t size) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < size; ++i) {
    hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3;
  }
  return hash;
}

bool areFinite(const nlohmann::json& content) {
  const nlohmann::json all = content.flatten();
  return std::all_of(all.begin(), all.end(), [](const nlohmann::json& value) {
    return !value.is_number_float() || std::isfinite(value.get<double>());
  });
}

}  // namespace

std::string serialise(const SavedState& state) {
  std::string bytes(kHead, '\0');
  nlohmann::json::to_cbor(state, bytes);
  const std::uint64_t head[] = {kMagic, hashOf(bytes.data() + kHead, bytes.size() - kHead)};
  std::memcpy(bytes.data(), head, kHead);
  return bytes;
}

SavedState deserialise(const char* bytes, std::size_t size) {
  std::uint64_t head[2] = {};
  std::memcpy(head, bytes, std::min(size, kHead));
  // The memory of a component holds places in lists, too, so nothing may be taken from bytes that were changed.
  element::refuseIf(size < kHead || head[0] != kMagic || head[1] != hashOf(bytes + kHead, size - kHead),
                    "the bytes are no serialised state, or were changed");
  const nlohmann::json content = nlohmann::json::from_cbor(bytes + kHead, bytes + size);
  auto state = content.get<SavedState>();
  element::refuseIf(!areFinite(content) || state.standing.phase > Phase::terminated,
                    "the serialised state holds a number that none has");
  return state;
}

std::uint64_t fingerprintOf(const std::string& guid) { return hashOf(guid.data(), guid.size()); }

}  // namespace rubber_suspension::fmi
