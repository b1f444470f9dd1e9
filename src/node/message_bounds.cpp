// What a message on the wire may be before it is decoded.
#include "node/message_bounds.h"

namespace rubber_suspension::node {
namespace {

constexpr std::size_t kSequenceAndStamp = 12;

// Goes over the fields of a message, each length held against the bytes that remain.
class Fields {
 public:
  Fields(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool atEnd() const { return left_ == 0; }

  bool skip(std::size_t size) {
    if (size > left_) {
      return false;
    }
    data_ += size;
    left_ -= size;
    return true;
  }

  // A length of four bytes, least significant first, at most `most`.
  bool length(std::size_t most, std::size_t& result) {
    if (left_ < 4) {
      return false;
    }
    result = static_cast<std::size_t>(data_[0]) | static_cast<std::size_t>(data_[1]) << 8U |
             static_cast<std::size_t>(data_[2]) << 16U | static_cast<std::size_t>(data_[3]) << 24U;
    return skip(4) && result <= most;
  }

  bool text(std::size_t longest) {
    std::size_t size = 0;
    return length(longest, size) && skip(size);
  }

  bool header() { return skip(kSequenceAndStamp) && text(kLongestFrameId); }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

bool skipTexts(Fields& fields, std::size_t most) {
  std::size_t count = 0;
  if (!fields.length(most, count)) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!fields.text(kLongestComponentName)) {
      return false;
    }
  }
  return true;
}

bool skipNumbers(Fields& fields, std::size_t most) {
  std::size_t count = 0;
  return fields.length(most, count) && fields.skip(count * sizeof(double));
}

}  // namespace

bool isStampedNumber(const std::uint8_t* data, std::size_t size) {
  Fields fields(data, size);
  return fields.header() && fields.skip(sizeof(double)) && fields.atEnd();
}

bool isStampedPair(const std::uint8_t* data, std::size_t size) {
  Fields fields(data, size);
  return fields.header() && fields.skip(2 * sizeof(double)) && fields.atEnd();
}

bool isBundle(const std::uint8_t* data, std::size_t size, std::size_t most_components) {
  Fields fields(data, size);
  return fields.header() && skipTexts(fields, most_components) && skipNumbers(fields, most_components) &&
         fields.atEnd();
}

std::size_t longestBundle(std::size_t components) {
  return kSequenceAndStamp + 4 + kLongestFrameId + 4 + components * (4 + kLongestComponentName) + 4 +
         components * sizeof(double);
}

}  // namespace rubber_suspension::node
