// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/mesh.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

namespace foldless {

// Arrays of numpy, or what it makes arrays of. Each throws TypeError where the numbers are not of a
// kind that fits, ValueError where the shape is not, in a sentence that names the argument.

/// Coordinates, n × 2.
PointMatrix points_argument(const pybind11::handle& value, const char* name);
/// Barycentric coordinates, n × 3.
CoordinateMatrix coordinates_argument(const pybind11::handle& value, const char* name);
/// Triangles, n × 3.
TriangleMatrix triangles_argument(const pybind11::handle& value, const char* name);
/// Indices, n.
std::vector<int> indices_argument(const pybind11::handle& value, const char* name);

}  // namespace foldless
