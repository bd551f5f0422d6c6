// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/parameter_value.h"

namespace foldless {
namespace {

double index_in(const ParameterKey& key, const JsonValue& value) {
  const auto index = index_of_word(key, value.text());
  if (!index)
    value.refuse("is " + value.shown() + ", which is unknown; known are " +
                 listed({key.words.begin(), key.words.end()}));
  return *index;
}

}  // namespace

double parameter_value(const ParameterKey& key, const JsonValue& value) {
  if (key.kind == ParameterKind::word) return index_in(key, value);
  const bool is_flag = key.kind == ParameterKind::flag;
  const double number = is_flag ? (value.boolean() ? 1 : 0) : value.number();
  if (const auto wrong = objection(key, number))
    value.refuse("is " + value.shown() + ", but " + *wrong);
  return number;
}

}  // namespace foldless
