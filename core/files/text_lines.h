// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace foldless {

/// A text, line by line; lines end in LF, CRLF or CR, and a byte order mark is skipped.
class TextLines {
 public:
  /// `text` must outlive the reader.
  explicit TextLines(std::string_view text);

  /// Goes to the next line; false at the end of the text.
  bool next();
  /// The line without its end.
  std::string_view line() const { return line_; }
  /// Number of the line, from 1.
  int number() const { return number_; }
  /// Everything after the line.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
};

/// The words of a line, separated by blanks and tabs.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}
  /// The next word, empty at the end of the line.
  std::string_view next();

 private:
  std::string_view rest_;
};

/// The line up to the first #.
std::string_view without_comment(std::string_view line);

/// The double nearest to a decimal number, whatever the locale; infinite when it is too large.
/// Nothing when the whole word is not a number.
std::optional<double> parse_number(std::string_view word);

/// A decimal integer in the range of int, or nothing.
std::optional<int> parse_integer(std::string_view word);

/// Adds the shortest decimal number that reads back as exactly `value`.
void append_number(std::string& text, double value);
void append_number(std::string& text, int value);

/// A word of a file inside quotation marks, fit for a message of one line.
std::string in_quotes(std::string_view word);

}  // namespace foldless
