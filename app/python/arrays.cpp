// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"

#include <cstdint>
#include <limits>
#include <string>

namespace py = pybind11;

namespace foldless {
namespace {

std::string words_of_shape(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

py::array array_of(const py::handle& value, const char* name) {
  py::array array = py::array::ensure(value);
  if (array) return array;
  PyErr_Clear();
  throw py::type_error(std::string(name) + " is not an array of numbers; give one of numpy");
}

/// `columns` 0: one row of numbers.
void check_shape(const py::array& array, const char* name, int columns) {
  const bool is_right =
      columns == 0 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (is_right) return;
  const std::string wanted = columns == 0 ? "(n,)" : "(n, " + std::to_string(columns) + ")";
  throw py::value_error(std::string(name) + " has the shape " + words_of_shape(array) +
                        "; it must be " + wanted);
}

std::string words_of_kind(const py::array& array) {
  return py::str(static_cast<py::object>(array.dtype())).cast<std::string>();
}

template <typename Matrix>
Matrix reals(const py::handle& value, const char* name, int columns) {
  py::array array = array_of(value, name);
  if (std::string("fiu").find(array.dtype().kind()) == std::string::npos)
    throw py::type_error(std::string(name) + " is of the type " + words_of_kind(array) +
                         "; give real numbers");
  check_shape(array, name, columns);
  const py::array_t<double, py::array::c_style | py::array::forcecast> numbers(array);
  return Eigen::Map<const Matrix>(numbers.data(), numbers.shape(0), columns);
}

/// Row by row.
std::vector<int> integers(const py::handle& value, const char* name, int columns) {
  py::array array = array_of(value, name);
  // An empty list makes an array of floats.
  if (std::string("iu").find(array.dtype().kind()) == std::string::npos && array.size() > 0)
    throw py::type_error(std::string(name) + " is of the type " + words_of_kind(array) +
                         "; give integers");
  check_shape(array, name, columns);
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> numbers(array);
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(numbers.size()));
  for (py::ssize_t i = 0; i < numbers.size(); ++i) {
    const std::int64_t number = numbers.data()[i];
    if (number < 0 || number > std::numeric_limits<int>::max())
      throw py::value_error(std::string(name) + " contains " + std::to_string(number) +
                            "; indices count from 0");
    result.push_back(static_cast<int>(number));
  }
  return result;
}

}  // namespace

PointMatrix points_argument(const py::handle& value, const char* name) {
  return reals<PointMatrix>(value, name, 2);
}

CoordinateMatrix coordinates_argument(const py::handle& value, const char* name) {
  return reals<CoordinateMatrix>(value, name, 3);
}

TriangleMatrix triangles_argument(const py::handle& value, const char* name) {
  const std::vector<int> rows = integers(value, name, 3);
  return Eigen::Map<const TriangleMatrix>(rows.data(), static_cast<Eigen::Index>(rows.size() / 3),
                                          3);
}

std::vector<int> indices_argument(const py::handle& value, const char* name) {
  return integers(value, name, 0);
}

}  // namespace foldless
