// A saved state as a sequence of 8-byte words: magic number, checksum, fingerprint of the FMU, a fixed list of numbers,
// the parameters, the memory of the component. The format is flat, so that any bytes can be read without recursion.
#include "fmi/runtime/saved_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "element/refuse.h"

namespace rubber_suspension::fmi {
namespace {

constexpr std::uint64_t kMagic = 0x3430544154535352;  // "RSSTAT04", lowest byte first
constexpr std::size_t kWords = 3;                     // magic number, checksum, fingerprint

// Returns references to the single numbers of a state in the order of the bytes.
template <class State, class Count>
auto singlesOf(State& state, Count& parameters) {
  auto& now = state.standing;
  return std::tie(now.phase, now.settled, parameters, now.time, now.stop_time, state.component_displacement,
                  now.has_temperature, now.degrees);
}
template <class State>
auto rowsOf(State& state) {
  auto& now = state.standing;
  return std::tie(now.inputs, now.outputs, now.derivative, now.parameters, state.memory);
}
constexpr std::size_t kHead = 8 + 2 * std::tuple_size_v<Numbers> + kMostDerivatives;

std::uint64_t hashOf(const char* bytes, std::size_t size) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < size; ++i) {
    hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3;
  }
  return hash;
}

// Returns the checksum of the bytes that follow the checksum.
std::uint64_t checksumOf(const char* bytes, std::size_t size) { return hashOf(bytes + 16, size - 16); }

}  // namespace

std::string serialise(const SavedState& state) {
  std::vector<double> numbers;
  const std::size_t parameters = state.standing.parameters.size();
  std::apply([&](const auto&... number) { numbers = {static_cast<double>(number)...}; }, singlesOf(state, parameters));
  std::apply([&](const auto&... row) { (numbers.insert(numbers.end(), row.begin(), row.end()), ...); }, rowsOf(state));
  std::uint64_t words[kWords] = {kMagic, 0, state.fingerprint};
  std::string bytes(reinterpret_cast<const char*>(words), sizeof words);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), 8 * numbers.size());
  words[1] = checksumOf(bytes.data(), bytes.size());
  return bytes.replace(0, sizeof words, reinterpret_cast<const char*>(words), sizeof words);
}

SavedState deserialise(const char* bytes, std::size_t size) {
  std::uint64_t words[kWords] = {};
  std::vector<double> numbers(size / 8 < kWords ? 0 : size / 8 - kWords);
  if (size % 8 == 0 && numbers.size() >= kHead) {
    std::memcpy(words, bytes, sizeof words);
    std::memcpy(numbers.data(), bytes + sizeof words, 8 * numbers.size());
  }
  // The memory of a component includes indices, so bytes that were changed must not be used.
  element::refuseIf(words[0] != kMagic || words[1] != checksumOf(bytes, size),
                    "the bytes are not a serialised state, or the state was changed");
  const double phase = numbers[0];
  const double parameters = numbers[2];
  element::refuseIf(!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }) ||
                        !(phase >= 0.0 && phase <= static_cast<double>(Phase::terminated)) ||
                        !(parameters >= 0.0 && parameters <= static_cast<double>(numbers.size() - kHead)),
                    "the serialised state contains a number that is out of range");
  SavedState state;
  state.fingerprint = words[2];
  auto next = numbers.begin();
  std::size_t count = 0;
  std::apply([&](auto&... number) { ((number = static_cast<std::decay_t<decltype(number)>>(*next++)), ...); },
             singlesOf(state, count));
  state.standing.parameters.resize(count);
  state.memory.resize(numbers.size() - kHead - count);
  const auto take = [&next](auto& row) {
    std::copy_n(next, row.size(), row.begin());
    next += static_cast<std::ptrdiff_t>(row.size());
  };
  std::apply([&](auto&... row) { (take(row), ...); }, rowsOf(state));
  return state;
}

std::uint64_t fingerprintOf(const std::string& guid) { return hashOf(guid.data(), guid.size()); }

}  // namespace rubber_suspension::fmi
