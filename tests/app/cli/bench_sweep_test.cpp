// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/cli/command.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Ended;
using test::read_text;
using test::TemporaryFolder;
using test::write_text;

/// Four scenes that take no time, two methods.
Ended sweep(std::vector<std::string> more) {
  std::vector<std::string> words{"bench",  "--suite", "random",   "--seed",      "1",
                                 "--only", "0,1,3,4", "--method", "foldless,lim"};
  words.insert(words.end(), more.begin(), more.end());
  return test::run(words);
}

/// results.json without what differs from run to run.
json rows_in(const std::string& folder) {
  json rows = json::parse(read_text(folder + "/results.json"));
  for (json& row : rows) row.erase("seconds");
  return rows;
}

TEST(Sweep, OfShardsThatWereKilledAndBegunAgainIsThatOfOneRun) {
  const TemporaryFolder folder;
  ASSERT_EQ(sweep({"-o", folder / "whole"}).status, 0);
  std::vector<std::string> files;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    files.push_back(folder / (std::string(1, shard[0]) + ".jsonl"));
    ASSERT_EQ(sweep({"--shard", shard, "--append", files.back()}).status, 0);
  }
  // Killed while it wrote its third line.
  const std::string second = read_text(files[1]);
  const std::size_t cut = second.find('\n', second.find('\n') + 1) + 40;
  write_text(files[1], second.substr(0, cut));
  const std::string first = read_text(files[0]);
  const Ended again = sweep({"--shard", "2/3", "--append", files[1]});
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.err.find("was cut off"), std::string::npos) << again.err;
  ASSERT_EQ(sweep({"--shard", "1/3", "--append", files[0]}).status, 0);
  EXPECT_EQ(read_text(files[0]), first) << "what is there was run again";

  const Ended merged =
      test::run({"bench", "--merge", files[2], files[0], files[1], "-o", folder / "merged"});
  EXPECT_EQ(merged.status, 0);
  EXPECT_EQ(merged.err, "");
  EXPECT_EQ(rows_in(folder / "merged"), rows_in(folder / "whole"));
}

TEST(Sweep, RecordsTellHowTheirRunCanBeMadeAgain) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.jsonl";
  ASSERT_EQ(sweep({"--shard", "1/8", "--append", file}).status, 0);
  const std::string text = read_text(file);
  const json record = json::parse(text.substr(0, text.find('\n')));
  for (const char* key : {"version", "machine", "suite", "seed", "time_limit", "scene", "energy",
                          "method", "parameters", "job", "jobs"})
    EXPECT_TRUE(record.contains(key)) << key;
  EXPECT_EQ(record["jobs"], 8);
}

TEST(Sweep, NotesWhatIsMissingFromItsFiles) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.jsonl";
  ASSERT_EQ(sweep({"--shard", "1/2", "--append", file}).status, 0);
  const Ended merged = test::run({"bench", "--merge", file});
  EXPECT_EQ(merged.status, 0);
  EXPECT_NE(merged.err.find("4 runs of 8 missing"), std::string::npos) << merged.err;
}

TEST(Sweep, RefusesFilesOfAnother) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.jsonl", other = folder / "b.jsonl";
  ASSERT_EQ(sweep({"--shard", "1/8", "--append", file}).status, 0);
  const Ended mixed = test::run({"bench", "--suite", "random", "--seed", "4", "--only", "0,1,3,4",
                                 "--method", "foldless,lim", "--append", file});
  EXPECT_EQ(mixed.status, 2);
  EXPECT_NE(mixed.err.find("has runs of another sweep"), std::string::npos) << mixed.err;
  std::string text = read_text(file);
  write_text(other, text.replace(text.find("\"seed\": \"1\""), 11, "\"seed\": \"4\""));
  const Ended merged = test::run({"bench", "--merge", file, other});
  EXPECT_EQ(merged.status, 2);
  EXPECT_NE(merged.err.find("is of another sweep"), std::string::npos) << merged.err;
  write_text(other, "{\"job\": 1}\n");
  const Ended no_record = test::run({"bench", "--merge", other});
  EXPECT_EQ(no_record.status, 2);
  EXPECT_NE(no_record.err.find("b.jsonl:1: is no record that bench --append wrote"),
            std::string::npos)
      << no_record.err;
}

TEST(Sweep, RefusesParametersThatNoRunCanHave) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.jsonl";
  ASSERT_EQ(sweep({"--shard", "1/8", "--append", file}).status, 0);
  const std::string text = read_text(file), count = "\"inner_iterations\": ";
  const std::size_t begin = text.find(count) + count.size();
  ASSERT_GT(begin, count.size());
  for (const char* wrong : {"1e48", "0", "1.5"}) {
    std::string other = text;
    write_text(file,
               other.replace(begin, text.find_first_not_of("0123456789", begin) - begin, wrong));
    const Ended merged = test::run({"bench", "--merge", file});
    EXPECT_EQ(merged.status, 2) << wrong;
    EXPECT_NE(merged.err.find("a.jsonl:1: is no record"), std::string::npos) << merged.err;
  }
}

TEST(Sweep, TakesFoldersAndListsOfScenes) {
  const TemporaryFolder folder;
  ASSERT_EQ(test::run({"bench", "--suite", "random", "--seed", "3", "--only", "0,6", "--method",
                       "paper-noflip", "--keep", folder / "scenes"})
                .status,
            0);
  std::string list;
  for (const std::string& name : test::names_in(folder / "scenes")) list += "scenes/" + name + '\n';
  write_text(folder / "list.txt", list);
  const Ended of_folder = test::run(
      {"bench", folder / "scenes", "--method", "paper-noflip", "-o", folder / "of_folder"});
  EXPECT_EQ(of_folder.status, 0) << of_folder.err;
  ASSERT_EQ(test::run({"bench", folder / "list.txt", "--method", "paper-noflip", "-o",
                       folder / "of_list"})
                .status,
            0);
  EXPECT_EQ(rows_in(folder / "of_folder").size(), 2U);
  EXPECT_EQ(rows_in(folder / "of_folder"), rows_in(folder / "of_list"));
}

TEST(Sweep, RefusesShardsThatAreNone) {
  for (const char* shard : {"0/3", "4/3", "1", "a/b", "1/0"}) {
    const Ended ended = sweep({"--shard", shard});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("--shard takes one of 1/N to N/N"), std::string::npos) << ended.err;
  }
  EXPECT_EQ(test::run({"bench", "--suite", "drag", "--shard", "1/2"}).status, 2);
  EXPECT_EQ(test::run({"bench", "--merge", "a.jsonl", "--shard", "1/2"}).status, 2);
}

}  // namespace
}  // namespace foldless
