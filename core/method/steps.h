// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <coroutine>
#include <exception>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "core/iteration.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// Some steps of a method in their natural order, loops and all, that end with a T: a coroutine.
///
///     const VertexUpdate update = co_await vertex_update(next);  // where it waits to be stepped
///     co_yield record;                                           // the record of that update
///     co_yield [&](Iteration& record) { … };                     // corrects it
///     const Progress progress = co_await approach(work);         // steps within steps
///
/// It waits at vertex_update() and, where it is stopped, at a Pause, and nowhere else, so whatever
/// follows an update, up to the next one, belongs to the same step of the method. Destroying it
/// while it waits is safe.
template <typename T = void>
class Steps;

class UpdateRequest;

/// What the coroutines of one method share.
struct StepContext {
  UpdateRequest* request = nullptr;  ///< that the innermost coroutine waits for
  std::coroutine_handle<> waiting;   ///< that coroutine
  std::optional<Iteration> record;   ///< of the update that was made last
};

/// An update that a coroutine waits for.
class UpdateRequest {
 public:
  /// Makes the update; false when it was cancelled, which changed nothing.
  virtual bool make(const std::stop_token& token) = 0;

  bool await_ready() const noexcept { return false; }
  template <typename Promise>
  void await_suspend(std::coroutine_handle<Promise> waiting) noexcept {
    StepContext& context = *waiting.promise().context;
    context.request = this;
    context.waiting = waiting;
  }

 protected:
  ~UpdateRequest() = default;
};

inline bool is_cancelled(const VertexUpdate& update) { return update.cancelled; }
inline bool is_cancelled(const std::optional<VertexUpdate>& update) {
  return update && update->cancelled;
}

/// See vertex_update().
template <typename Make>
class VertexUpdateRequest final : public UpdateRequest {
 public:
  using Update = std::invoke_result_t<Make&, std::stop_token>;

  explicit VertexUpdateRequest(Make& make) : make_(make) {}

  bool make(const std::stop_token& token) override {
    update_ = make_(token);
    return !is_cancelled(*update_);
  }

  Update await_resume() { return *std::move(update_); }

 private:
  Make& make_;
  std::optional<Update> update_;
};

/// Waits until the method is stepped, then makes `make(stop_token)`, again with every step until it
/// is not cancelled, and gives its result.
template <typename Make>
VertexUpdateRequest<Make> vertex_update(Make& make) {
  return VertexUpdateRequest<Make>(make);
}

/// co_await Pause() waits for the next step where a stop is requested: between two things that take
/// long on a large mesh and do not look at a token.
class Pause final : public UpdateRequest {
 public:
  bool make(const std::stop_token& token) override { return !token.stop_requested(); }
  void await_resume() const noexcept {}
};

/// What the promises of all Steps have in common.
struct StepsPromiseBase {
  StepContext* context = nullptr;
  std::coroutine_handle<> caller;  ///< resumed when these steps have ended
  std::exception_ptr failure;

  struct ToCaller {
    bool await_ready() const noexcept { return false; }
    template <typename Promise>
    std::coroutine_handle<> await_suspend(std::coroutine_handle<Promise> ended) noexcept {
      const std::coroutine_handle<> next = ended.promise().caller;
      return next ? next : std::noop_coroutine();
    }
    void await_resume() const noexcept {}
  };

  std::suspend_always initial_suspend() const noexcept { return {}; }
  ToCaller final_suspend() const noexcept { return {}; }
  std::suspend_never yield_value(const Iteration& record) noexcept {
    context->record = record;
    return {};
  }
  template <std::invocable<Iteration&> Correct>
  std::suspend_never yield_value(const Correct& correct) {
    if (context->record) correct(*context->record);
    return {};
  }
  void unhandled_exception() noexcept { failure = std::current_exception(); }
};

template <typename T>
struct StepsPromise : StepsPromiseBase {
  std::optional<T> result;

  Steps<T> get_return_object();
  template <typename Value>
  void return_value(Value&& value) {
    result.emplace(std::forward<Value>(value));  // T may be an optional itself
  }
  T take_result() {
    if (failure) std::rethrow_exception(failure);
    return *std::move(result);
  }
};

template <>
struct StepsPromise<void> : StepsPromiseBase {
  Steps<void> get_return_object();
  void return_void() const noexcept {}
  void take_result() const {
    if (failure) std::rethrow_exception(failure);
  }
};

template <typename T>
class [[nodiscard]] Steps {
 public:
  using promise_type = StepsPromise<T>;
  using Handle = std::coroutine_handle<promise_type>;

  explicit Steps(Handle handle) : handle_(handle) {}
  ~Steps() {
    if (handle_) handle_.destroy();
  }
  Steps(Steps&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
  Steps& operator=(Steps&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }

  /// Runs them up to their first update, or to their end.
  void begin(StepContext& context) {
    handle_.promise().context = &context;
    handle_.resume();
  }
  bool have_ended() const { return handle_.done(); }
  /// Precondition: they have ended. Throws what they threw.
  T result() { return handle_.promise().take_result(); }

  bool await_ready() const noexcept { return false; }
  template <typename Promise>
  Handle await_suspend(std::coroutine_handle<Promise> caller) noexcept {
    handle_.promise().context = caller.promise().context;
    handle_.promise().caller = caller;
    return handle_;
  }
  T await_resume() { return result(); }

 private:
  Handle handle_;
};

template <typename T>
Steps<T> StepsPromise<T>::get_return_object() {
  return Steps<T>(std::coroutine_handle<StepsPromise>::from_promise(*this));
}
inline Steps<void> StepsPromise<void>::get_return_object() {
  return Steps<void>(std::coroutine_handle<StepsPromise>::from_promise(*this));
}

}  // namespace foldless
