// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

/// Of functions for lanes: they are compiled for the processors of the loop that they are part of.
#define FOLDLESS_INLINED [[gnu::always_inline]] inline

namespace foldless {

/// Vectors as compilers have them; GCC takes no size that depends on a template's parameter.
template <int Count>
struct VectorOf;
template <>
struct VectorOf<2> {
  using Numbers [[gnu::vector_size(16)]] = double;
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
};
template <>
struct VectorOf<4> {
  using Numbers [[gnu::vector_size(32)]] = double;
  using Bits [[gnu::vector_size(32)]] = std::int64_t;
};

template <>
struct VectorOf<8> {
  using Numbers [[gnu::vector_size(64)]] = double;
  using Bits [[gnu::vector_size(64)]] = std::int64_t;
};

/// As many numbers, each of another triangle, on which every operation is done at once. What is
/// written for a `Real` is meant for one double or for lanes; a lane has the bits of that one
/// double, as nothing is contracted or reordered.
template <int Count>
struct Lanes {
  using Numbers = typename VectorOf<Count>::Numbers;
  /// What a comparison says in every lane.
  struct Mask {
    typename VectorOf<Count>::Bits bits;
  };

  Numbers numbers;

  Lanes() = default;
  FOLDLESS_INLINED explicit Lanes(const Numbers& of) : numbers(of) {}
  /// The same in every lane. Subtracting 0 keeps the sign of 0.
  FOLDLESS_INLINED Lanes(double number) : numbers(number - Numbers{}) {}  // NOLINT: as a double is

  FOLDLESS_INLINED friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return Lanes(a.numbers + b.numbers);
  }
  FOLDLESS_INLINED friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return Lanes(a.numbers - b.numbers);
  }
  FOLDLESS_INLINED friend Lanes operator-(const Lanes& a) { return Lanes(-a.numbers); }
  FOLDLESS_INLINED friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return Lanes(a.numbers * b.numbers);
  }
  FOLDLESS_INLINED friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return Lanes(a.numbers / b.numbers);
  }
  FOLDLESS_INLINED Lanes& operator+=(const Lanes& a) { return *this = *this + a; }
  FOLDLESS_INLINED Lanes& operator-=(const Lanes& a) { return *this = *this - a; }
  FOLDLESS_INLINED friend Mask operator>=(const Lanes& a, const Lanes& b) {
    return {a.numbers >= b.numbers};
  }
  FOLDLESS_INLINED friend Mask operator>(const Lanes& a, const Lanes& b) {
    return {a.numbers > b.numbers};
  }
  FOLDLESS_INLINED friend Mask operator==(const Lanes& a, const Lanes& b) {
    return {a.numbers == b.numbers};
  }

  FOLDLESS_INLINED friend Lanes square_root(const Lanes& a) {
    Lanes root;
    for (int i = 0; i < Count; ++i) root.numbers[i] = std::sqrt(a.numbers[i]);
    return root;
  }
  FOLDLESS_INLINED friend Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
    return Lanes(mask.bits ? yes.numbers : no.numbers);
  }
  FOLDLESS_INLINED friend Mask both(const Mask& a, const Mask& b) { return {a.bits & b.bits}; }
  FOLDLESS_INLINED friend bool is_all(const Mask& mask) {
    bool all = true;
    for (int i = 0; i < Count; ++i) all = all && mask.bits[i] != 0;
    return all;
  }
};

FOLDLESS_INLINED double square_root(double a) { return std::sqrt(a); }
FOLDLESS_INLINED double select(bool mask, double yes, double no) { return mask ? yes : no; }
FOLDLESS_INLINED bool both(bool a, bool b) { return a && b; }
FOLDLESS_INLINED bool is_all(bool mask) { return mask; }

}  // namespace foldless
