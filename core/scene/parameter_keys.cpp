// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/parameter_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/files/text_lines.h"

namespace foldless {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kLargestInteger = std::numeric_limits<int>::max();

template <auto Member>
std::optional<double> get(const Parameters& parameters) {
  if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(parameters.*Member)>>)
    return static_cast<double>(parameters.*Member);
  else
    return static_cast<std::optional<double>>(parameters.*Member);
}

template <auto Member>
void set(Parameters& parameters, double value) {
  using Value = std::remove_cvref_t<decltype(parameters.*Member)>;
  if constexpr (std::is_enum_v<Value>)
    parameters.*Member = static_cast<Value>(static_cast<int>(value));
  else
    parameters.*Member = static_cast<Value>(value);
}

/// A real number greater than 0.
template <auto Member>
constexpr ParameterKey positive(std::string_view name) {
  return {name, ParameterKind::real, 0, kNoLimit, true, get<Member>, set<Member>, {}};
}

/// A real number of at least 0.
template <auto Member>
constexpr ParameterKey not_negative(std::string_view name) {
  return {name, ParameterKind::real, 0, kNoLimit, false, get<Member>, set<Member>, {}};
}

template <auto Member>
constexpr ParameterKey count(std::string_view name) {
  return {name, ParameterKind::whole, 1, kLargestInteger, false, get<Member>, set<Member>, {}};
}

template <auto Member>
constexpr ParameterKey flag(std::string_view name) {
  return {name, ParameterKind::flag, 0, 1, false, get<Member>, set<Member>, {}};
}

/// The words of StartFrames, in its order.
constexpr std::array<std::string_view, 3> kStartWords{"rest", "unconstrained", "continuation"};

template <auto Member>
constexpr ParameterKey word(std::string_view name, std::span<const std::string_view> words) {
  return {name,  ParameterKind::word, 0,           static_cast<double>(words.size() - 1),
          false, get<Member>,         set<Member>, words};
}

constexpr std::array kKeys{
    positive<&Parameters::alpha>("alpha"),
    not_negative<&Parameters::beta>("beta"),
    ParameterKey{"delta",
                 ParameterKind::real,
                 0,
                 1,
                 true,
                 get<&Parameters::delta>,
                 set<&Parameters::delta>,
                 {}},
    not_negative<&Parameters::eta>("eta"),
    count<&Parameters::inner_iterations>("inner_iterations"),
    count<&Parameters::outer_iterations>("outer_iterations"),
    not_negative<&Parameters::gradient_tolerance>("gradient_tolerance"),
    not_negative<&Parameters::step_tolerance>("step_tolerance"),
    flag<&Parameters::condition_test>("condition_test"),
    flag<&Parameters::area_weighted>("area_weighted"),
    word<&Parameters::start>("start", kStartWords),
    ParameterKey{"distortion_bound",
                 ParameterKind::real,
                 1,
                 kNoLimit,
                 true,
                 get<&Parameters::distortion_bound>,
                 set<&Parameters::distortion_bound>,
                 {}},
};

bool is_inside(const ParameterKey& key, double value) {
  return key.bounds_excluded ? key.minimum < value && value < key.maximum
                             : key.minimum <= value && value <= key.maximum;
}

std::string text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace

std::span<const ParameterKey> parameter_keys() { return kKeys; }

const ParameterKey* find_parameter_key(std::string_view name) {
  const auto key = std::ranges::find(kKeys, name, &ParameterKey::name);
  return key == kKeys.end() ? nullptr : &*key;
}

std::optional<double> index_of_word(const ParameterKey& key, std::string_view word) {
  const auto it = std::ranges::find(key.words, word);
  if (it == key.words.end()) return std::nullopt;
  return static_cast<double>(it - key.words.begin());
}

std::optional<std::string> objection(const ParameterKey& key, double value) {
  const bool is_whole = key.kind == ParameterKind::real || std::trunc(value) == value;
  if (std::isfinite(value) && is_whole && is_inside(key, value)) return std::nullopt;
  std::string words = key.kind == ParameterKind::real ? "must be a number " : "must be an integer ";
  words += (key.bounds_excluded ? "greater than " : "of at least ") + text_of(key.minimum);
  if (key.maximum == kNoLimit) return words;
  return words + (key.bounds_excluded ? " and less than " : " and at most ") + text_of(key.maximum);
}

}  // namespace foldless
