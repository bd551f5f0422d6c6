// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/json_node.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::error_of;

std::string error_in_json(std::string_view text) {
  return error_of([&] { parse_json(text, "a.json"); });
}

TEST(JsonNode, KnowsTheLineOfEveryValue) {
  const JsonNode root =
      parse_json("{\n\"a\": 1\n,\"b\": [2,\n3\n,\n\n4.5\n],\n \"c\"\n:\n true}", "a");
  const auto& object = *root.as<JsonNode::Object>();
  EXPECT_EQ(root.line, 1);
  EXPECT_EQ(object[0].value.line, 2);
  const auto& array = *object[1].value.as<JsonNode::Array>();
  EXPECT_EQ(array[0].line, 3);
  EXPECT_EQ(array[1].line, 4);
  EXPECT_EQ(array[2].line, 7);
  EXPECT_EQ(object[2].value.line, 11);
}

TEST(JsonNode, RefusesWhatIsNotJsonWithTheLine) {
  for (const char* text : {"", "{", "{\"a\": }", "[1, 2", "nul", "{} {}", "{\"a\": nan}", "[1,]",
                           "{'a': 1}", "\"\xff\""}) {
    const std::string error = error_in_json(text);
    EXPECT_TRUE(error.starts_with("a.json:1: not JSON: ")) << error;
    EXPECT_EQ(error.find('\n'), error.npos);
  }
  EXPECT_TRUE(error_in_json("{\n\"a\": 1,\n\"b\" 2}").starts_with("a.json:3: not JSON: "));
}

TEST(JsonNode, RefusesNumbersThatAreTooLarge) {
  EXPECT_TRUE(error_in_json("[1,\n1e999]").starts_with("a.json:2: not JSON: number overflow"))
      << error_in_json("[1,\n1e999]");
}

TEST(JsonNode, RefusesAKeyThatComesTwice) {
  EXPECT_EQ(error_in_json("{\"a\": 1,\n\"b\": {\"a\": 2},\n\"a\": 3}"),
            "a.json:3: the key 'a' comes twice, first in line 1");
}

TEST(JsonNode, TellsWhereInTheFileItIsNotJson) {
  EXPECT_TRUE(
      error_in_json(R"({"a": 1, "b": [{"c": 2}, {"d": [3, 4, x]}]})").ends_with(", in b[1].d[2]"));
  EXPECT_TRUE(error_in_json("{\"a\\nb\": x}").ends_with(", in a?b")) << "one line";
}

TEST(JsonNode, RefusesDeepNesting) {
  EXPECT_EQ(error_in_json(std::string(100000, '[')),
            "a.json:1: values are nested more than 100 levels deep");
  EXPECT_EQ(error_in_json(std::string(100, '[') + std::string(100, ']')), "");
}

TEST(JsonNode, RefusesObjectsOfTooManyKeysWithoutComparingThemAll) {
  std::string text = "{";
  for (int i = 0; i < 200000; ++i) text += '"' + std::to_string(i) + "\": 0,\n";
  EXPECT_EQ(error_in_json(text), "a.json:10001: an object has more than 10000 keys");
}

TEST(JsonText, PutsPointsAndHandlesOnOneLineEach) {
  const std::string text =
      "{\n  \"mesh\": {\n    \"vertices\": [\n      [0, 0.5],\n      [1, -0.0]\n    ]\n  },\n"
      "  \"handles\": [\n    {\"vertex\": 3, \"target\": [1e-05, 2]}\n  ],\n  \"solver\": {},\n"
      "  \"text\": \"a\\\"b\\n\",\n  \"flags\": [true, false, null]\n}\n";
  EXPECT_EQ(json_text(parse_json(text, "a")), text);
}

TEST(JsonText, ReadsBackEveryNumberBitForBit) {
  const unsigned seed = 17;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  JsonNode::Array numbers{{0.0}, {-0.0}, {5e-324}, {1.7976931348623157e308}, {0x1p63}, {0x1p64}};
  while (numbers.size() < 20000) {
    const double x = std::bit_cast<double>(random());
    if (std::isfinite(x)) numbers.push_back({x});
  }
  const JsonNode node{numbers};
  const JsonNode back = parse_json(json_text(node), "a");
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*numbers[i].as<double>()),
              std::bit_cast<std::uint64_t>(*(*back.as<JsonNode::Array>())[i].as<double>()));
}

TEST(JsonText, WritesWholeNumbersAsIntegers) {
  const std::vector<std::pair<double, std::string>> numbers{
      {100000, "100000"},      {-2e5, "-200000"}, {1e15, "1000000000000000"},  {0, "0"},
      {1e5 + 0.5, "100000.5"}, {1e300, "1e+300"}, {0x1p53, "9007199254740992"}};
  for (const auto& [number, text] : numbers) {
    const std::string written = json_text({number});
    EXPECT_EQ(written.substr(0, written.find_last_not_of('\n') + 1), text);
    EXPECT_EQ(*parse_json(written, "a").as<double>(), number);
  }
}

TEST(JsonText, RefusesNumbersThatAreNotFinite) {
  EXPECT_NE(error_of([] { json_text({std::nan("")}); }), "");
}

TEST(JsonNode, GoesThroughTheLibraryUnchanged) {
  const std::string text = "{\"a\": [1, 2.5, true, null, \"x\"], \"b\": {\"c\": {}}}";
  const JsonNode node = parse_json(text, "a");
  EXPECT_EQ(to_library(node), nlohmann::json::parse(text));
  EXPECT_EQ(json_text(from_library(to_library(node))), json_text(node));
}

}  // namespace
}  // namespace foldless
