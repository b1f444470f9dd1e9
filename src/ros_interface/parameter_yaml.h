// Parameters of the parameter server as the YAML text that the component file's loader reads.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

namespace rubber_suspension::ros_interface {

/// The value as YAML in the style of JSON. Numbers keep every bit. A string that is a number as a whole, as roslaunch
/// leaves `3.0e6`, is written as that number; every other string is quoted. Throws std::invalid_argument for what no
/// component file can hold (dates, binary data) and for nesting deeper than any component file.
std::string toYamlText(const XmlRpc::XmlRpcValue& value);

}  // namespace rubber_suspension::ros_interface
