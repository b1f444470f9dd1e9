// Reads a file as UTF-8 text. Boost decompresses gzip, iconv converts UTF-16.
#include "log/text_source.h"

#include <fmt/format.h>
#include <iconv.h>
#include <sys/stat.h>

#include <algorithm>
#include <boost/iostreams/concepts.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "element/refuse.h"
#include "log/file_format.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

class FileBytes final : public ByteSource {
 public:
  explicit FileBytes(const std::string& path) : file_(nullptr, std::fclose) {
    refuseNamedPipe(path);
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_) {
      throw std::runtime_error(std::strerror(errno));
    }
  }

  std::size_t read(char* to, std::size_t size) override {
    const std::size_t count = std::fread(to, 1, size, file_.get());
    if (std::ferror(file_.get()) != 0) {
      throw std::runtime_error(std::strerror(errno));
    }
    return count;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

// Returns the size of a regular file, and 0 for anything else.
std::size_t sizeOfFile(const std::string& path) {
  struct stat status{};
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
}

// A source whose first bytes can be inspected before they are read.
class PeekedSource final : public ByteSource {
 public:
  explicit PeekedSource(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {
    head_.resize(kFormatHead);
    std::size_t filled = 0;
    for (std::size_t count = 1; count > 0 && filled < head_.size(); filled += count) {
      count = source_->read(&head_[filled], head_.size() - filled);
    }
    head_.resize(filled);
  }

  const std::string& head() const { return head_; }
  void skip(std::size_t count) { taken_ += count; }

  std::size_t read(char* to, std::size_t size) override {
    if (taken_ == head_.size()) {
      return source_->read(to, size);
    }
    const std::size_t count = std::min(size, head_.size() - taken_);
    std::memcpy(to, &head_[taken_], count);
    taken_ += count;
    return count;
  }

 private:
  std::unique_ptr<ByteSource> source_;
  std::string head_;
  std::size_t taken_ = 0;
};

constexpr std::size_t kPortion = 64 * 1024;  // number of bytes that are decoded at a time

// Passes compressed bytes to the library and counts them.
struct PackedBytes : boost::iostreams::source {
  ByteSource* source;
  std::size_t* count;

  std::streamsize read(char* to, std::streamsize size) const {
    const std::size_t taken = source->read(to, static_cast<std::size_t>(size));
    *count += taken;
    return taken == 0 ? -1 : static_cast<std::streamsize>(taken);
  }
};

// Decompresses a gzip file, which may consist of several members.
class GzipSource final : public ByteSource {
 public:
  GzipSource(std::unique_ptr<ByteSource> source, bool large, std::size_t size)
      : source_(std::move(source)), large_(large), size_(size) {
    stream_.push(boost::iostreams::gzip_decompressor(), kPortion);
    stream_.push(PackedBytes{{}, source_.get(), &packed_}, kPortion);
    stream_.exceptions(std::ios::badbit);
  }

  std::size_t read(char* to, std::size_t size) override {
    try {
      stream_.read(to, static_cast<std::streamsize>(size));
    } catch (const boost::iostreams::gzip_error& error) {
      namespace io = boost::iostreams;
      const bool is_cut = error.error() == io::gzip::bad_footer || error.zlib_error_code() == io::zlib::buf_error;
      throw std::runtime_error(
          fmt::format("gzip: {}; accepted: a complete file", is_cut ? "the file ends early" : "damaged data"));
    }
    const auto count = static_cast<std::size_t>(stream_.gcount());
    unpacked_ += count;
    refuseUnpacked(unpacked_, packed_, large_, size_);
    return count;
  }

 private:
  std::unique_ptr<ByteSource> source_;
  bool large_;
  std::size_t size_;        // size of the file; 0: unknown
  std::size_t packed_ = 0;  // compressed bytes read so far
  std::size_t unpacked_ = 0;
  boost::iostreams::filtering_istream stream_;
};

class Utf16Source final : public ByteSource {
 public:
  Utf16Source(std::unique_ptr<ByteSource> source, bool little_endian)
      : source_(std::move(source)),
        converter_(iconv_open("UTF-8", little_endian ? "UTF-16LE" : "UTF-16BE")),
        input_(kPortion) {
    // iconv_open() returns -1 on failure.
    if (converter_ == reinterpret_cast<iconv_t>(-1)) {  // NOLINT(performance-no-int-to-ptr)
      throw std::runtime_error("UTF-16: this system cannot convert it; accepted: UTF-8");
    }
  }
  Utf16Source(const Utf16Source&) = delete;
  Utf16Source& operator=(const Utf16Source&) = delete;
  ~Utf16Source() override { iconv_close(converter_); }

  std::size_t read(char* to, std::size_t size) override {
    char* out = to;
    std::size_t room = size;
    while (room == size) {
      char* in = input_.data();
      std::size_t left = held_;
      const bool failed = iconv(converter_, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
      element::refuseIf<std::runtime_error>(failed && errno == EILSEQ,
                                            "UTF-16: damaged text; accepted: UTF-8 or complete UTF-16");
      std::memmove(input_.data(), in, left);
      held_ = left;
      if (room == size && !refill()) {
        return 0;
      }
    }
    return size - room;
  }

 private:
  bool refill() {
    const std::size_t count = source_->read(input_.data() + held_, input_.size() - held_);
    held_ += count;
    element::refuseIf<std::runtime_error>(count == 0 && held_ > 0,
                                          "UTF-16: the file ends within a character; accepted: a complete file");
    return count > 0;
  }

  std::unique_ptr<ByteSource> source_;
  iconv_t converter_;
  std::vector<char> input_;
  std::size_t held_ = 0;
};

enum class Encoding { bytes, utf16_little_endian, utf16_big_endian };

// Recognises UTF-16 without a byte order mark. Most characters of a log are ASCII, so that every other byte is 0.
Encoding guessedEncoding(const std::string& head) {
  std::size_t zeros[2] = {};
  for (std::size_t i = 0; i < head.size(); ++i) {
    zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  }
  const std::size_t pairs = head.size() / 2;
  if (pairs < 4 || zeros[0] + zeros[1] < pairs * 9 / 10) {
    return Encoding::bytes;
  }
  return zeros[0] == 0 ? Encoding::utf16_little_endian : zeros[1] == 0 ? Encoding::utf16_big_endian : Encoding::bytes;
}

void note(std::string& coding, const std::string& what) { coding += (coding.empty() ? "" : ", ") + what; }

}  // namespace

TextSource openText(const std::string& path, bool large) {
  TextSource result;
  auto source = std::make_unique<PeekedSource>(std::make_unique<FileBytes>(path));
  if (formatOf(source->head()) == FileFormat::gzip) {
    source = std::make_unique<PeekedSource>(std::make_unique<GzipSource>(std::move(source), large, sizeOfFile(path)));
    note(result.coding, "gzip");
  }
  refuseForeignFormat(source->head());
  Encoding encoding = guessedEncoding(source->head());
  if (startsWith(source->head(), "\xEF\xBB\xBF")) {
    source->skip(3);
  } else if (startsWith(source->head(), "\xFF\xFE") || startsWith(source->head(), "\xFE\xFF")) {
    encoding = source->head()[0] == '\xFF' ? Encoding::utf16_little_endian : Encoding::utf16_big_endian;
    source->skip(2);
  }
  result.bytes = std::move(source);
  if (encoding != Encoding::bytes) {
    result.bytes = std::make_unique<Utf16Source>(std::move(result.bytes), encoding == Encoding::utf16_little_endian);
    note(result.coding, "UTF-16");
  }
  return result;
}

std::string readText(const std::string& path, std::size_t maximum_size) {
  const TextSource source = openText(path, false);
  std::string text(maximum_size + 1, '\0');
  std::size_t filled = 0;
  for (std::size_t count = 1; count > 0 && filled < text.size(); filled += count) {
    count = source.bytes->read(&text[filled], text.size() - filled);
  }
  text.resize(filled);
  element::refuseIf<std::runtime_error>(filled > maximum_size, "more than {0} bytes; accepted: at most {0}",
                                        maximum_size);
  return text;
}

LineReader::LineReader(std::unique_ptr<ByteSource> source, std::size_t maximum_line)
    : source_(std::move(source)), maximum_line_(maximum_line), buffer_(2 * maximum_line + 1) {
  fill();
  findLineEnd();
}

void LineReader::fill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  std::size_t count = 1;
  while (count > 0 && end_ < buffer_.size() - 1) {
    count = source_->read(buffer_.data() + end_, buffer_.size() - 1 - end_);
    end_ += count;
  }
}

void LineReader::findLineEnd() {
  const auto holds = [&](char c) { return std::memchr(buffer_.data(), c, end_) != nullptr; };
  line_end_ = !holds('\n') && holds('\r') ? '\r' : '\n';
}

char* LineReader::next() {
  char* line_end = static_cast<char*>(std::memchr(buffer_.data() + begin_, line_end_, end_ - begin_));
  if (line_end == nullptr) {
    fill();
    line_end = static_cast<char*>(std::memchr(buffer_.data(), line_end_, end_));
  }
  if (begin_ == end_) {
    return nullptr;
  }
  ++line_;
  ended_ = line_end != nullptr;
  if (line_end == nullptr) {
    line_end = buffer_.data() + end_;
  }
  char* const line = buffer_.data() + begin_;
  const std::size_t length = static_cast<std::size_t>(line_end - line);
  element::refuseIf<std::runtime_error>(length > maximum_line_, "line of more than {} bytes", maximum_line_);
  if (std::memchr(line, '\0', length) != nullptr) {
    throw std::runtime_error("holds a 0 byte; accepted: text in UTF-8, UTF-16 or Latin-1");
  }
  begin_ += length + (ended_ ? 1 : 0);
  *line_end = '\0';
  while (line_end > line && line_end[-1] == '\r') {
    *--line_end = '\0';
  }
  return line;
}

}  // namespace rubber_suspension::log
