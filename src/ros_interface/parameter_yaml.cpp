// Parameters of the parameter server as YAML text.
#include "ros_interface/parameter_yaml.h"

#include <cerrno>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "element/refuse.h"

namespace rubber_suspension::ros_interface {
namespace {

using nlohmann::json;
using XmlRpc::XmlRpcValue;

constexpr int kDeepest = 16;

// Returns a number if the text is one that a component file accepts. strtod also reads hexadecimal numbers, "nan" and
// "inf", which component files do not accept.
json ofText(const std::string& text) {
  char* end = nullptr;
  errno = 0;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos || *end != '\0' || errno != 0) {
    return text;
  }
  const json whole = json::parse(text, nullptr, false);  // not an integer if the spelling is not JSON, such as 1.e6
  return whole.is_number_integer() ? whole : json(number);
}

json toJson(const XmlRpcValue& value, int depth) {
  element::refuseIf(depth > kDeepest, "the value is nested too deeply; accepted: at most {} levels", kDeepest);
  json result;
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpcValue::TypeInt:
      return static_cast<int>(value);
    case XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpcValue::TypeString:
      return ofText(value);
    case XmlRpcValue::TypeArray:
      result = json::array();
      for (int i = 0; i < value.size(); ++i) {
        result.push_back(toJson(value[i], depth + 1));
      }
      return result;
    case XmlRpcValue::TypeStruct:
      result = json::object();
      for (const auto& entry : value) {
        result[entry.first] = toJson(entry.second, depth + 1);
      }
      return result;
    default:
      throw std::invalid_argument(
          "contains a date, binary data or an empty value; accepted: numbers, text, lists and maps");
  }
}

}  // namespace

std::string toYamlText(const XmlRpcValue& value) {
  return toJson(value, 0).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace rubber_suspension::ros_interface
