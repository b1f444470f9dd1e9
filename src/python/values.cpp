// Conversion of arrays, numbers with units and elements between Python and C++.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "log/text.h"
#include "python/bindings.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::python {
namespace {

const element::ParameterInfo& findParameter(const element::ElementType& type, const std::string& name) {
  if (const element::ParameterInfo* parameter = element::findParameter(type.parameters, name)) {
    return *parameter;
  }
  const std::vector<std::string> names = element::namesOf(type.parameters);
  throw std::invalid_argument(fmt::format("{}: unknown key '{}'{}; accepted: {}", type.name, name,
                                          element::didYouMean(name, names), log::join(names)));
}

const element::ElementType& findType(const py::dict& entry) {
  element::refuseIf(!entry.contains("type"), "type is missing; accepted: the name of an element");
  const auto name = py::cast<std::string>(py::str(entry["type"]));
  if (const element::ElementType* type = element::findElementType(name)) {
    return *type;
  }
  const std::vector<std::string> names = element::namesOf(element::elementTypes());
  throw std::invalid_argument(
      fmt::format("'{}' is not an element{}; accepted: {}", name, element::didYouMean(name, names), log::join(names)));
}

bool isList(const py::handle& value) {
  return !py::isinstance<py::str>(value) && (py::isinstance<py::sequence>(value) || py::isinstance<py::array>(value));
}

std::vector<double> toNumbers(const py::handle& value, const element::ParameterInfo& parameter) {
  std::vector<double> numbers;
  if (!isList(value)) {
    return {toNumber(value, parameter)};
  }
  for (const py::handle number : value) {
    numbers.push_back(toNumber(number, parameter));
  }
  return numbers;
}

}  // namespace

std::vector<double> toVector(const py::object& values_in, const std::string& name) {
  const py::array any = py::array::ensure(values_in);
  if (!any) {
    PyErr_Clear();
    throw std::invalid_argument(name + " is not an array; accepted: an array of real numbers");
  }
  const bool masked =
      py::hasattr(values_in, "mask") && py::bool_(py::array::ensure(values_in.attr("mask")).attr("any")());
  if (masked || std::string("fiu").find(any.dtype().kind()) == std::string::npos) {
    throw std::invalid_argument(
        fmt::format("{}: has {}; accepted: real numbers", name,
                    masked ? "masked values" : "numbers of type " + py::cast<std::string>(py::str(any.dtype()))));
  }
  const Array array = Array::ensure(any);
  element::refuseIf(array.ndim() != 1, "{}: has {} dimensions; accepted: one dimension", name, array.ndim());
  std::vector<double> values(array.data(), array.data() + array.size());
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (bad != values.end()) {
    throw std::invalid_argument(
        fmt::format("{}[{}]: {} is not finite; accepted: a finite number", name, bad - values.begin(), *bad));
  }
  return values;
}

Array toArray(const std::vector<double>& values) {
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

double toNumber(const py::handle& value, const element::ParameterInfo& parameter) {
  if (!py::isinstance<py::str>(value)) {
    try {
      return py::cast<double>(value);
    } catch (const py::cast_error&) {
      throw std::invalid_argument(
          fmt::format("{}: {} is not a number; accepted: a number in {}, or text with such a unit", parameter.name,
                      log::quoted(py::cast<std::string>(py::repr(value))), parameter.unit));
    }
  }
  const auto text = py::cast<std::string>(value);
  try {
    return log::parseQuantity(text, parameter.unit);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}: {}; accepted: a number in {}, or text with such a unit",
                                            parameter.name, log::quoted(text), error.what(), parameter.unit));
  }
}

std::vector<element::ElementDescription> toElements(const py::sequence& entries) {
  std::vector<element::ElementDescription> elements;
  for (const py::handle entry : entries) {
    if (!py::isinstance<py::dict>(entry)) {
      throw std::invalid_argument("an element is not a dict; accepted: {'type': NAME, PARAMETER: VALUE, ...}");
    }
    const auto fields = py::reinterpret_borrow<py::dict>(entry);
    const element::ElementType& type = findType(fields);
    element::ElementDescription element{type.name, {}};
    for (const auto& [key, value] : fields) {
      const auto name = py::cast<std::string>(py::str(key));
      if (name == "of_rig") {
        if (!py::isinstance<py::bool_>(value)) {
          throw std::invalid_argument(type.name + ".of_rig: is not a truth value; accepted: True or False");
        }
        element.of_rig = py::cast<bool>(value);
      } else if (name != "type") {
        element.values[name] = toNumbers(value, findParameter(type, name));
      }
    }
    elements.push_back(std::move(element));
  }
  return elements;
}

py::list fromElements(const std::vector<element::ElementDescription>& elements) {
  py::list result;
  for (const element::ElementDescription& element : elements) {
    py::dict entry;
    entry["type"] = element.type;
    for (const auto& [name, values] : element.values) {
      if (values.size() == 1) {
        entry[name.c_str()] = values.front();
      } else {
        entry[name.c_str()] = values;
      }
    }
    if (element::isOfRig(element)) {
      entry["of_rig"] = true;
    }
    result.append(entry);
  }
  return result;
}

py::object madeByInit(const py::handle& type, const py::handle& derived, const py::args& args,
                      const py::kwargs& values) {
  if (PyType_Check(derived.ptr()) == 0 || PyType_IsSubtype(reinterpret_cast<PyTypeObject*>(derived.ptr()),
                                                           reinterpret_cast<PyTypeObject*>(type.ptr())) == 0) {
    throw py::type_error("__new__: the class is not accepted; accepted: " +
                         py::str(type.attr("__name__")).cast<std::string>() + " or a class that is derived from it");
  }
  auto object =
      py::reinterpret_steal<py::object>(py::detail::make_new_instance(reinterpret_cast<PyTypeObject*>(derived.ptr())));
  derived.attr("__init__")(object, *args, **values);
  return object;
}

}  // namespace rubber_suspension::python
