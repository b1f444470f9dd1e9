// A saved state as a row of 8-byte words: a fixed head, then the parameters, then the memory of the component.
#include "fmi/runtime/saved_state.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace rubber_suspension::fmi {
namespace {

constexpr std::uint64_t kMagic = 0x3230544154535352;  // "RSSTAT02", lowest byte first
constexpr std::size_t kChecksumWord = 1;              // behind the magic number
constexpr std::size_t kHeadWords = 12 + kMostDerivatives + 4;

// FNV-1a over the bytes from a word on.
std::uint64_t hashOf(const char* bytes, std::size_t size) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < size; ++i) {
    hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3;
  }
  return hash;
}

// Of all that stands behind it.
std::uint64_t checksumOf(const char* bytes, std::size_t size) {
  constexpr std::size_t kBegin = 8 * (kChecksumWord + 1);
  return hashOf(bytes + kBegin, size - kBegin);
}

class Writer {
 public:
  explicit Writer(char* bytes) : bytes_(bytes) {}

  template <class Word>
  void put(Word word) {
    static_assert(sizeof(Word) == 8, "a word has 8 bytes");
    std::memcpy(bytes_, &word, sizeof(word));
    bytes_ += sizeof(word);
  }

 private:
  char* bytes_;
};

class Reader {
 public:
  Reader(const char* bytes, std::size_t size) : bytes_(bytes), words_left_(size / 8) {}

  template <class Word>
  Word get() {
    static_assert(sizeof(Word) == 8, "a word has 8 bytes");
    if (words_left_ == 0) {
      throw std::invalid_argument("the serialised state ends too early");
    }
    Word word;
    std::memcpy(&word, bytes_, sizeof(word));
    bytes_ += sizeof(word);
    --words_left_;
    return word;
  }

  double finite() {
    const auto value = get<double>();
    if (!std::isfinite(value)) {
      throw std::invalid_argument("the serialised state holds a number that is not finite");
    }
    return value;
  }

  std::vector<double> finiteList(std::uint64_t size) {
    if (size > words_left_) {
      throw std::invalid_argument("the serialised state ends too early");
    }
    std::vector<double> list(size);
    for (double& value : list) {
      value = finite();
    }
    return list;
  }

 private:
  const char* bytes_;
  std::size_t words_left_;
};

Phase phaseOf(std::uint64_t word) {
  if (word > static_cast<std::uint64_t>(Phase::terminated)) {
    throw std::invalid_argument("the serialised state is in no phase that can be continued");
  }
  return static_cast<Phase>(word);
}

}  // namespace

std::size_t serialisedSize(const SavedState& state) {
  return 8 * (kHeadWords + state.parameters.size() + state.memory.size());
}

void serialise(const SavedState& state, char* bytes) {
  Writer out(bytes);
  out.put(kMagic);
  out.put(std::uint64_t{0});  // for the checksum
  out.put(state.fingerprint);
  out.put(static_cast<std::uint64_t>(state.phase));
  out.put(static_cast<std::uint64_t>(state.settled ? 1 : 0));
  out.put(static_cast<std::uint64_t>(state.parameters.size()));
  out.put(static_cast<std::uint64_t>(state.memory.size()));
  out.put(state.time);
  out.put(state.displacement);
  out.put(state.component_displacement);
  out.put(state.temperature.value_or(0.0));
  out.put(static_cast<std::uint64_t>(state.temperature ? 1 : 0));
  for (const double derivative : state.derivative) {
    out.put(derivative);
  }
  for (const double part : {state.force.total, state.force.elastic, state.force.viscous, state.force.friction}) {
    out.put(part);
  }
  for (const std::vector<double>* list : {&state.parameters, &state.memory}) {
    for (const double value : *list) {
      out.put(value);
    }
  }
  const std::uint64_t checksum = checksumOf(bytes, serialisedSize(state));
  std::memcpy(bytes + 8 * kChecksumWord, &checksum, sizeof(checksum));
}

SavedState deserialise(const char* bytes, std::size_t size) {
  Reader in(bytes, size);
  // The memory of a component holds places in lists, too, so nothing may be taken from bytes that were changed.
  const bool whole = size >= 8 * kHeadWords && size % 8 == 0 && in.get<std::uint64_t>() == kMagic &&
                     in.get<std::uint64_t>() == checksumOf(bytes, size);
  if (!whole) {
    throw std::invalid_argument("the bytes are no serialised state, or were changed");
  }
  SavedState state;
  state.fingerprint = in.get<std::uint64_t>();
  state.phase = phaseOf(in.get<std::uint64_t>());
  state.settled = in.get<std::uint64_t>() != 0;
  const auto parameters = in.get<std::uint64_t>();
  const auto memory = in.get<std::uint64_t>();
  state.time = in.finite();
  state.displacement = in.finite();
  state.component_displacement = in.finite();
  const double temperature = in.finite();
  if (in.get<std::uint64_t>() != 0) {
    state.temperature = temperature;
  }
  for (double& derivative : state.derivative) {
    derivative = in.finite();
  }
  for (double* part : {&state.force.total, &state.force.elastic, &state.force.viscous, &state.force.friction}) {
    *part = in.finite();
  }
  state.parameters = in.finiteList(parameters);
  state.memory = in.finiteList(memory);
  if (serialisedSize(state) != size) {
    throw std::invalid_argument("the serialised state has another size than it says");
  }
  return state;
}

std::uint64_t fingerprintOf(const std::string& guid) { return hashOf(guid.data(), guid.size()); }

}  // namespace rubber_suspension::fmi
