// Limits of the size of a serialised message, checked before it is decoded.
#include "node/message_bounds.h"

#include <algorithm>

namespace rubber_suspension::node {
namespace {

constexpr std::size_t kSequenceAndStamp = 12;
constexpr std::size_t kLength = 4;

// Reads the fields of a message. Each field is checked against the number of remaining bytes. After the first field
// that does not fit, all further fields fail.
class Fields {
 public:
  Fields(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool fit() const { return fit_; }
  bool areAll() const { return fit_ && left_ == 0; }

  void skip(std::size_t size) {
    fit_ = fit_ && size <= left_;
    left_ -= std::min(size, left_);
    data_ += fit_ ? size : 0;
  }

  // Reads a length of four bytes, the least significant first. Fails and returns 0 if the length exceeds `most`.
  std::size_t length(std::size_t most) {
    const std::uint8_t* const at = data_;
    skip(kLength);
    std::size_t result = 0;
    for (unsigned byte = 0; fit_ && byte < kLength; ++byte) {
      result |= static_cast<std::size_t>(at[byte]) << 8U * byte;
    }
    fit_ = fit_ && result <= most;
    return fit_ ? result : 0;
  }

  void header() {
    skip(kSequenceAndStamp);
    skip(length(kLongestFrameId));
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
  bool fit_ = true;
};

}  // namespace

template <std::size_t kNumbers>
bool isStamped(const std::uint8_t* data, std::size_t size) {
  Fields fields(data, size);
  fields.header();
  fields.skip(kNumbers * sizeof(double));
  return fields.areAll();
}

template bool isStamped<1>(const std::uint8_t* data, std::size_t size);
template bool isStamped<2>(const std::uint8_t* data, std::size_t size);
template bool isStamped<kWrenchNumbers>(const std::uint8_t* data, std::size_t size);
template bool isStamped<kPoseNumbers>(const std::uint8_t* data, std::size_t size);

bool isBundle(const std::uint8_t* data, std::size_t size, std::size_t most_components, std::size_t numbers) {
  Fields fields(data, size);
  fields.header();
  for (std::size_t names = fields.length(most_components); names > 0 && fields.fit(); --names) {
    fields.skip(fields.length(kLongestComponentName));
  }
  fields.skip(fields.length(most_components) * numbers * sizeof(double));
  return fields.areAll();
}

std::size_t longestBundle(std::size_t components, std::size_t numbers) {
  return kSequenceAndStamp + kLength + kLongestFrameId + kLength + components * (kLength + kLongestComponentName) +
         kLength + components * numbers * sizeof(double);
}

}  // namespace rubber_suspension::node
