// Whether an XML-RPC body is one that XmlRpcpp reads in a time that grows with its length.
#include "roscpp_fixes/xmlrpc_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace rubber_suspension::roscpp_fixes {
namespace {

constexpr const char* kMulticall = "system.multicall";

bool isNumber(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end != text.c_str();
}

bool isInteger(const std::string& text) {
  char* end = nullptr;
  std::strtol(text.c_str(), &end, 10);
  return end != text.c_str();
}

bool isBoolean(const std::string& text) {
  const long value = std::strtol(text.c_str(), nullptr, 10);
  return isInteger(text) && (value == 0 || value == 1);
}

bool isDate(const std::string& text) {
  std::array<int, 6> part{};
  return std::sscanf(text.c_str(), "%4d%2d%2dT%2d:%2d:%2d", &part[0], &part[1], &part[2], &part[3], &part[4],
                     &part[5]) == 6;
}

// As XmlRpcpp's own parser goes over the body, place by place.
class Body {
 public:
  Body(const std::string& text, std::size_t longest) : text_(text), most_work_(longest / 8) {
    if (text.size() > longest) {
      refuse(fmt::format("{} bytes; accepted: at most {}", text.size(), longest));
    }
  }

  const std::string& refusal() const { return refusal_; }

  // Behind the tag, wherever it comes next.
  bool find(std::string_view tag) {
    const std::size_t found = refusal_.empty() ? text_.find(tag, place_) : std::string::npos;
    place_ = found == std::string::npos ? place_ : found + tag.size();
    return found != std::string::npos;
  }

  // Behind the tag, if it comes next.
  bool next(std::string_view tag) {
    std::size_t at = place_;
    while (at < text_.size() && std::isspace(static_cast<unsigned char>(text_[at])) != 0) {
      ++at;
    }
    const bool is_next = refusal_.empty() && text_.compare(at, tag.size(), tag) == 0;
    place_ = is_next ? at + tag.size() : place_;
    return is_next;
  }

  // A value, if one comes next.
  bool value(int depth = 1) {
    if (!next("<value>")) {
      return false;
    }
    work_ += static_cast<std::size_t>(depth);
    if (depth > kDeepestValue) {
      refuse(fmt::format("values within values; accepted: at most {} deep", kDeepestValue));
    } else if (work_ > most_work_) {
      refuse(fmt::format("values whose depths add up to more than {}", most_work_));
    }
    if (next("<array>")) {
      array(depth);
    } else if (next("<struct>")) {
      structure(depth);
    } else {
      leaf();
    }
    need("</value>");
    return true;
  }

  void need(const char* tag) {
    if (!next(tag)) {
      refuse(fmt::format("no {} where one is needed, at byte {}", tag, place_));
    }
  }

  std::string_view text() {
    const std::size_t begin = place_;
    place_ = std::min(text_.find('<', begin), text_.size());
    return std::string_view(text_).substr(begin, place_ - begin);
  }

 private:
  void refuse(std::string why) { refusal_ = refusal_.empty() ? std::move(why) : refusal_; }

  void array(int depth) {
    need("<data>");
    while (value(depth + 1)) {
    }
    need("</data>");
    need("</array>");
  }

  void structure(int depth) {
    while (next("<member>")) {
      need("<name>");
      text();
      need("</name>");
      if (!value(depth + 1)) {
        need("<value>");
      }
      need("</member>");
    }
    need("</struct>");
  }

  void leaf() {
    struct Kind {
      const char* begin;
      const char* end;
      bool (*holds)(const std::string& text);
    };
    static constexpr std::array<Kind, 7> kKinds = {{{"<i4>", "</i4>", isInteger},
                                                    {"<int>", "</int>", isInteger},
                                                    {"<boolean>", "</boolean>", isBoolean},
                                                    {"<double>", "</double>", isNumber},
                                                    {"<dateTime.iso8601>", "</dateTime.iso8601>", isDate},
                                                    {"<string>", "</string>", nullptr},
                                                    {"<base64>", "</base64>", nullptr}}};
    const auto* const kind =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& each) { return next(each.begin); });
    constexpr std::size_t kLongestNumber = 400;  // what is longer is read as far as it is one
    const std::string content(text().substr(0, kLongestNumber));
    if (kind == kKinds.end()) {
      return;  // text without a type
    }
    if (kind->holds != nullptr && !kind->holds(content)) {
      refuse(fmt::format("what follows {} at byte {} is none", kind->begin, place_));
    }
    need(kind->end);
  }

  const std::string& text_;
  const std::size_t most_work_;
  std::size_t place_ = 0;
  std::size_t work_ = 0;
  std::string refusal_;
};

}  // namespace

std::string requestRefusal(const std::string& body, std::size_t longest) {
  Body reader(body, longest);
  // XmlRpcpp answers a multicall within a multicall by that very multicall, without an end.
  if (body.find(kMulticall) != body.rfind(kMulticall)) {
    return fmt::format("{} more than once", kMulticall);
  }
  if (reader.find("<methodName>") && reader.find("</methodName>") && reader.find("<params>")) {
    while (reader.next("<param>")) {
      if (!reader.value()) {
        reader.need("<value>");
      }
      reader.next("</param>");
    }
  }
  return reader.refusal();
}

std::string replyRefusal(const std::string& body, std::size_t longest) {
  Body reader(body, longest);
  if (reader.find("<methodResponse>") &&
      ((reader.next("<params>") && reader.next("<param>")) || reader.next("<fault>")) && !reader.value()) {
    reader.need("<value>");
  }
  return reader.refusal();
}

}  // namespace rubber_suspension::roscpp_fixes
