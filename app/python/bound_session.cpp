// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/bound_session.h"

#include <chrono>
#include <future>

#include "app/python/arrays.h"

namespace py = pybind11;

namespace foldless {
namespace {

/// How often a run asks Python whether a signal has come.
constexpr std::chrono::milliseconds kPatience{50};

py::array_t<double> array_of_points(const PointMatrix& points) {
  py::array_t<double> array({points.rows(), Eigen::Index{2}});
  std::copy_n(points.data(), points.size(), array.mutable_data());
  return array;
}

}  // namespace

BoundSession::BoundSession(const py::handle& rest, const py::handle& triangles,
                           const py::handle& handles, const py::handle& targets,
                           const SolveOptions& options)
    : session_(points_argument(rest, "V"), triangles_argument(triangles, "F"),
               indices_argument(handles, "handles"), points_argument(targets, "targets"), options),
      targets_(array_of_points(points_argument(targets, "targets"))),
      sent_(points_argument(targets, "targets")) {}

void BoundSession::set_targets(const py::handle& targets) {
  const PointMatrix points = points_argument(targets, "targets");
  session_.set_targets(points);
  sent_ = points;
  std::copy_n(points.data(), points.size(), targets_.mutable_data());
}

void BoundSession::send_targets() {
  const Eigen::Map<const PointMatrix> written(targets_.data(), sent_.rows(), 2);
  if (written == sent_) return;
  session_.set_targets(written);
  sent_ = written;
}

bool BoundSession::step() {
  return interruptibly([this] { return session_.step(); });
}

bool BoundSession::run() {
  return interruptibly([this] { return session_.run(); });
}

bool BoundSession::is_reached() {
  send_targets();
  return session_.is_reached();
}

bool BoundSession::has_ended() {
  send_targets();
  return session_.has_ended();
}

/// Python hears of signals in its main thread only, which may be this one: the work is another's.
bool BoundSession::interruptibly(const std::function<bool()>& work) {
  send_targets();
  std::future<bool> done = std::async(std::launch::async, work);
  const auto wait = [&] {
    const py::gil_scoped_release released;
    return done.wait_for(kPatience) == std::future_status::ready;
  };
  while (!wait()) {
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set interruption;
    session_.cancel();
    {
      const py::gil_scoped_release released;
      done.wait();
    }
    throw interruption;
  }
  return done.get();
}

}  // namespace foldless
