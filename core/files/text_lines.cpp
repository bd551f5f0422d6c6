// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>

namespace foldless {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

/// Shortest form with room for every number.
template <typename Number>
void append_shortest(std::string& text, Number value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

/// from_chars takes no plus sign.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

/// The exponent that is written, as far as it matters.
long exponent_of(std::string_view word) {
  constexpr long kVeryMuch = 1'000'000'000'000;
  const std::size_t at = word.find_first_of("eE");
  if (at == word.npos) return 0;
  const std::string_view digits = without_plus(word.substr(at + 1));
  long exponent = 0;
  if (std::from_chars(digits.begin(), digits.end(), exponent).ec != std::errc() ||
      std::abs(exponent) > kVeryMuch)
    return digits.starts_with('-') ? -kVeryMuch : kVeryMuch;
  return exponent;
}

/// Of a number other than 0 that is out of range: near 0 rather than too large, of which
/// from_chars tells no difference. Its first digit other than 0 stands for a power of 10 below 1.
bool is_tiny(std::string_view word) {
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  const std::size_t first = word.find_first_of("123456789");
  const std::size_t point = std::min(word.find('.'), end);
  return static_cast<long>(point) - static_cast<long>(first) + exponent_of(word) <= 0;
}

}  // namespace

TextLines::TextLines(std::string_view text) : rest_(text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end);
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
  ++number_;
  return true;
}

std::string_view Words::next() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  const std::size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return word;
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

std::optional<double> parse_number(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return {};
  if (error == std::errc()) return value;
  const double sign = word.starts_with('-') ? -1 : 1;
  return sign * (is_tiny(word) ? 0 : std::numeric_limits<double>::infinity());
}

std::optional<int> parse_integer(std::string_view word) {
  word = without_plus(word);
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return value;
}

void append_number(std::string& text, double value) { append_shortest(text, value); }
void append_number(std::string& text, int value) { append_shortest(text, value); }

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kLongest)) text += c < ' ' || c > '~' ? '?' : c;
  if (word.size() > kLongest) text += "...";
  return text + "'";
}

}  // namespace foldless
