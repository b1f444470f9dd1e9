// Parameters of the parameter server as YAML text.
#include "ros_interface/parameter_yaml.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

constexpr int kDeepest = 16;

bool isNumber(const std::string& text) {
  // strtod also reads hexadecimal, "nan" and "inf"; none of them is a number of a component file.
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos) {
    return false;
  }
  char* end = nullptr;
  errno = 0;
  std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size() && errno == 0;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += '\\';
      result += character;
    } else if (byte < 0x20) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += character;
    }
  }
  return result + '"';
}

std::string write(const XmlRpcValue& value, int depth);

std::string writeArray(const XmlRpcValue& value, int depth) {
  std::string result = "[";
  for (int i = 0; i < value.size(); ++i) {
    result += (i == 0 ? "" : ", ") + write(value[i], depth + 1);
  }
  return result + "]";
}

std::string writeStruct(const XmlRpcValue& value, int depth) {
  std::string result = "{";
  for (const auto& entry : value) {
    result += (result.size() == 1 ? "" : ", ") + quoted(entry.first) + ": " + write(entry.second, depth + 1);
  }
  return result + "}";
}

std::string write(const XmlRpcValue& value, int depth) {
  if (depth > kDeepest) {
    throw std::invalid_argument(fmt::format("nested deeper than {} levels", kDeepest));
  }
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return fmt::format("{}", static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return fmt::format("{:.17g}", static_cast<double>(value));
    case XmlRpcValue::TypeString: {
      const std::string& text = static_cast<const std::string&>(value);
      return isNumber(text) ? text : quoted(text);
    }
    case XmlRpcValue::TypeArray:
      return writeArray(value, depth);
    case XmlRpcValue::TypeStruct:
      return writeStruct(value, depth);
    default:
      throw std::invalid_argument("holds a date, binary data or nothing; accepted: numbers, text, lists and maps");
  }
}

}  // namespace

std::string toYamlText(const XmlRpcValue& value) { return write(value, 0); }

}  // namespace rubber_suspension::ros_interface
