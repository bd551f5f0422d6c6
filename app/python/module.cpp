// SPDX-License-Identifier: GPL-3.0-or-later
// foldless._foldless: what the package foldless is made of. Its words for users are in
// foldless/__init__.pyi and in the docstrings here.
#include <foldless/check.h>
#include <foldless/energy.h>
#include <foldless/version.h>
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/arrays.h"
#include "app/python/bound_session.h"
#include "app/python/pictures.h"

namespace py = pybind11;

namespace foldless {
namespace {

template <typename Enumerator>
std::string word(Enumerator value) {
  return std::string(name_of(value));
}

void bind_iteration(py::module_& module) {
  py::class_<Iteration> bound(module, "Iteration",
                              "The record of one vertex update; lengths are those of the input.");
  bound.def_property_readonly("phase", [](const Iteration& i) { return word(i.phase); });
  bound.def_readonly("distortion_energy", &Iteration::distortion_energy)
      .def_readonly("penalty_energy", &Iteration::penalty_energy)
      .def_readonly("barrier_energy", &Iteration::barrier_energy)
      .def_readonly("energy", &Iteration::energy)
      .def_readonly("gradient_norm_squared", &Iteration::gradient_norm_squared)
      .def_readonly("handle_error_squared", &Iteration::handle_error_squared)
      .def_readonly("step_length", &Iteration::step_length)
      .def_readonly("min_area_ratio", &Iteration::min_area_ratio)
      .def_readonly("max_conformal_distortion", &Iteration::max_conformal_distortion)
      .def_readonly("mean_conformal_distortion", &Iteration::mean_conformal_distortion)
      .def_readonly("factorizations", &Iteration::factorizations)
      .def_readonly("updates", &Iteration::updates)
      .def_readonly("flips", &Iteration::flips)
      .def_readonly("splits", &Iteration::splits)
      .def_readonly("seconds", &Iteration::seconds);
}

/// `map(points)`, or `map(triangles, coordinates)` with a second argument.
PointMatrix mapped(const Result& result, const py::object& first, const py::object& second) {
  if (second.is_none()) {
    const PointMatrix points = points_argument(first, "points");
    const py::gil_scoped_release released;
    return result.map(points);
  }
  const std::vector<int> triangles = indices_argument(first, "triangles");
  const CoordinateMatrix coordinates = coordinates_argument(second, "coordinates");
  const py::gil_scoped_release released;
  return result.map(Eigen::Map<const Eigen::VectorXi>(triangles.data(),
                                                      static_cast<Eigen::Index>(triangles.size())),
                    coordinates);
}

void bind_result(py::module_& module) {
  py::class_<Parents>(module, "Parents", "How the vertices of a result lie in the input mesh.")
      .def_readonly("triangles", &Parents::triangles,
                    "(#U,) the input triangle of every vertex; -1: none")
      .def_readonly("coordinates", &Parents::coordinates,
                    "(#U, 3) barycentric coordinates of every vertex in it")
      .def_readonly("outputs", &Parents::outputs, "(#V,) the vertex of every input vertex");
  py::class_<Result>(module, "Result", "A mesh and its image under a map without folds.")
      .def_readonly("V", &Result::rest, "(#U, 2) at rest, the vertices of the input first")
      .def_readonly("F", &Result::triangles, "(#F, 3) triangles of V and U")
      .def_readonly("U", &Result::deformed, "(#U, 2) deformed")
      .def_readonly("parents", &Result::parents, "how V lies in the input mesh")
      .def_readonly("reached", &Result::is_reached, "every handle is at its target")
      .def_readonly("verdict", &Result::verdict,
                    "one sentence on how it ended, where there is more to say")
      .def_property_readonly(
          "outcome",
          [](const Result& r) { return r.outcome ? py::cast(word(*r.outcome)) : py::none(); },
          "gradient, step, iteration-limit, infeasible, not-converged, cancelled, time-limit, or "
          "None while it can go on")
      .def_readonly("log", &Result::log, "an Iteration for every vertex update")
      .def("map", &mapped, py::arg("points"), py::arg("coordinates") = py::none(),
           "map(points) takes (#P, 2) points of the input mesh to where they are deformed;\n"
           "map(triangles, coordinates) those in (#P,) input triangles at (#P, 3) barycentric\n"
           "coordinates.");
}

void bind_session(py::module_& module) {
  py::class_<BoundSession>(module, "Session",
                           "A run that goes on whenever its targets move: s.targets[3] = x, y.")
      .def(py::init([](const py::object& V, const py::object& F, const py::object& handles,
                       const py::object& targets, std::string energy,
                       std::optional<double> time_limit, int threads, bool fixed_triangulation,
                       std::optional<double> beta) {
             return std::make_unique<BoundSession>(
                 V, F, handles, targets,
                 SolveOptions{std::move(energy), time_limit, threads, fixed_triangulation, beta});
           }),
           py::arg("V"), py::arg("F"), py::arg("handles"), py::arg("targets"), py::kw_only(),
           py::arg("energy") = "arap", py::arg("time_limit") = py::none(), py::arg("threads") = 1,
           py::arg("fixed_triangulation") = false, py::arg("beta") = py::none())
      .def_property("targets", &BoundSession::targets, &BoundSession::set_targets,
                    "(#handles, 2) where the handles are to go; write into it or replace it")
      .def("step", &BoundSession::step, "One vertex update; False when there was none.")
      .def("run", &BoundSession::run,
           "Steps to the end; False when the time limit or cancel() stopped it.")
      .def("cancel", &BoundSession::cancel,
           "From another thread: ends the step() or run() under way, or the next.")
      .def_property_readonly("result", &BoundSession::result, "the newest valid mesh, a Result")
      .def_property_readonly("U", &BoundSession::deformed, "(#U, 2) deformed, of the newest mesh")
      .def_property_readonly("reached", &BoundSession::is_reached)
      .def_property_readonly("ended", &BoundSession::has_ended);
}

py::dict words_of_folds(const Folds& folds) {
  py::dict words;
  words["inverted"] = folds.inverted;
  words["degenerate"] = folds.degenerate;
  words["branch_vertices"] = folds.branch_vertices;
  words["overlapping_boundary_vertices"] = folds.overlapping_boundary_vertices;
  return words;
}

py::dict checked(const py::object& V, const py::object& F, const py::object& U) {
  const CheckedMap map =
      check(points_argument(V, "V"), triangles_argument(F, "F"), points_argument(U, "U"));
  py::dict words;
  words["injective"] = map.is_injective();
  words["rest"] = words_of_folds(map.rest);
  words["deformed"] = words_of_folds(map.deformed);
  words["min_area_ratio"] = map.min_area_ratio;
  words["max_conformal_distortion"] = map.max_conformal_distortion;
  words["mean_conformal_distortion"] = map.mean_conformal_distortion;
  return words;
}

void bind_functions(py::module_& module) {
  module.def("check", &checked, py::arg("V"), py::arg("F"), py::arg("U"));
  module.def("energies", [] {
    std::vector<std::string> names;
    for (const EnergyWords& energy : energies()) names.push_back(energy.name);
    return names;
  });
  module.def(
      "mesh_image",
      [](const std::filesystem::path& path, const std::string& detail) {
        PictureMesh mesh;
        {
          const py::gil_scoped_release released;
          mesh = mesh_of_picture(path, detail);
        }
        return py::make_tuple(std::move(mesh.rest), std::move(mesh.triangles));
      },
      py::arg("path"), py::kw_only(), py::arg("detail") = "medium");
  module.def(
      "render",
      [](const Result& result, const std::filesystem::path& path, const std::string& view,
         int width, int height, const std::optional<std::filesystem::path>& texture) {
        const py::gil_scoped_release released;
        draw(result, path, {view, width, height, texture});
      },
      py::arg("result"), py::arg("path"), py::kw_only(), py::arg("view") = "both",
      py::arg("width") = 1200, py::arg("height") = 900, py::arg("texture") = py::none());
}

}  // namespace
}  // namespace foldless

PYBIND11_MODULE(_foldless, module) {
  module.attr("__version__") = foldless::library_version();
  py::register_exception<foldless::Error>(module, "Error", PyExc_ValueError);
  foldless::bind_iteration(module);
  foldless::bind_result(module);
  foldless::bind_session(module);
  foldless::bind_functions(module);
}
