// Code that the parts of the Python module share: conversions of values, and functions that add the parts.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns the values of any object that NumPy converts to an array of real numbers of one dimension. Throws
/// std::invalid_argument, which names the argument, if the object has another number of dimensions, a number that is
/// not finite, or other contents (complex numbers, dates, structures, masked values).
std::vector<double> toVector(const py::object& values, const std::string& name);

/// Returns an array with its own copy of the values.
Array toArray(const std::vector<double>& values);

/// Converts a number, or text with a unit, to the SI unit of the parameter. Throws std::invalid_argument.
double toNumber(const py::handle& value, const element::ParameterInfo& parameter);

/// Converts entries such as {"type": "friction", "maximum_force": "6 kN", ...}, as in a component file. Throws
/// std::invalid_argument.
std::vector<element::ElementDescription> toElements(const py::sequence& entries);
py::list fromElements(const std::vector<element::ElementDescription>& elements);

/// Returns an object of the class `derived`, which must be `type` or a subclass of it, initialised by its own
/// `__init__`. Throws py::type_error.
py::object madeByInit(const py::handle& type, const py::handle& derived, const py::args& args,
                      const py::kwargs& values);

/// Makes `__new__` of a class return an initialised object. This is needed because pickle, copy and users call
/// `__new__` directly, and an object without `__init__` would refer to no C++ object.
template <class T>
py::class_<T>& makeByNew(py::class_<T>& type) {
  return type.def_static("__new__", [](const py::handle& derived, const py::args& args, const py::kwargs& values) {
    return madeByInit(py::type::of<T>(), derived, args, values);
  });
}

void addErrors(py::module_& module);
void addLogs(py::module_& module);
void addComponents(py::module_& module);
void addDiagnosis(py::module_& module);

}  // namespace rubber_suspension::python
