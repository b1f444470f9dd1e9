// Code that the parts of the Python module share: how values cross the border, and who adds what.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::python {

namespace py = pybind11;

/// An array of doubles.
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The values of anything that NumPy makes an array of real numbers, of one dimension. Throws std::invalid_argument
/// that names the argument where it has another number of dimensions, other contents (complex numbers, dates,
/// structures, masked values), or a number that is not finite.
std::vector<double> toVector(const py::object& values, const std::string& name);

/// An array of its own memory.
Array toArray(const std::vector<double>& values);

/// A number, or text with a unit, in the parameter's SI unit. Throws std::invalid_argument.
double toNumber(const py::handle& value, const element::ParameterInfo& parameter);

/// {"type": "friction", "maximum_force": "6 kN", ...}: values as in a component file. Throws std::invalid_argument.
std::vector<element::ElementDescription> toElements(const py::sequence& entries);
py::list fromElements(const std::vector<element::ElementDescription>& elements);

/// An object of a class, or of one that is derived from it, made by its own `__init__`. Throws py::type_error.
py::object madeByInit(const py::handle& type, const py::handle& derived, const py::args& args,
                      const py::kwargs& values);

/// Let `__new__` of a class make it whole, as pickle, copy and the curious call it: what no `__init__` has made would
/// be memory of nobody.
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
