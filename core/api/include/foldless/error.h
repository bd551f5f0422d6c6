// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace foldless {

/// Bad input from outside: a file, an argument, a number. what() is one complete sentence
/// for the user, `FILE:LINE: what is wrong and what to do` where a file and a line are known.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace foldless
