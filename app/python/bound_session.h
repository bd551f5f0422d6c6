// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/session.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <functional>

namespace foldless {

/// A session as Python has it: its targets are an array that one writes into, and every step begins
/// with what is in it. Solving leaves the interpreter to other threads, and signals to Python.
class BoundSession {
 public:
  /// Throws as Session, and ValueError or TypeError.
  BoundSession(const pybind11::handle& rest, const pybind11::handle& triangles,
               const pybind11::handle& handles, const pybind11::handle& targets,
               const SolveOptions& options);

  /// #handles × 2, of this object: what is written into it counts.
  pybind11::array_t<double> targets() const { return targets_; }
  void set_targets(const pybind11::handle& targets);

  bool step();
  /// Throws what a handler of signals throws, such as KeyboardInterrupt, within a second or so.
  bool run();
  void cancel() { session_.cancel(); }

  Result result() const { return session_.result(); }
  PointMatrix deformed() const { return session_.deformed(); }
  bool is_reached();
  bool has_ended();

 private:
  void send_targets();
  bool interruptibly(const std::function<bool()>& work);

  Session session_;
  pybind11::array_t<double> targets_;
  PointMatrix sent_;
};

}  // namespace foldless
