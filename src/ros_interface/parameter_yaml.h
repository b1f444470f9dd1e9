// Parameters of the parameter server as YAML text, which the loader of component files reads.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

namespace rubber_suspension::ros_interface {

/// Returns the value as YAML in the style of JSON. Numbers are exact to the last bit. A string that is a number, such
/// as `3.0e6` from roslaunch, is written as that number; other strings are quoted. Throws std::invalid_argument for
/// types that a component file cannot contain (dates, binary data) and for values that are nested more deeply than any
/// component file.
std::string toYamlText(const XmlRpc::XmlRpcValue& value);

}  // namespace rubber_suspension::ros_interface
