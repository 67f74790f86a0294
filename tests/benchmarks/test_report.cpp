#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "benchmarks/report.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::benchmarks {
namespace {

Report sample() {
  Report report{"demo", true, 7, {"a | processor", 2}, {}};
  report.rows.push_back({"Errors",
                         "bars | and\nlines",
                         "<= 0.5 px",
                         {{"ours", 0.123456, "px"}},
                         {{"other \"method\"", std::nan(""), "px"}},
                         true});
  report.rows.push_back({"Errors", "second", "<= 1", {{"share", 3, ""}}, {}, false});
  report.rows.push_back({"Time", "no goal", "", {{"median", 12.5, "ms"}}, {}, std::nullopt});
  return report;
}

TEST(Report, MarkdownKeepsItsColumns) {
  const std::string text = toMarkdown(sample());
  EXPECT_NE(text.find("| bars \\| and lines | <= 0.5 px | ours 0.123 px | other \"method\" - px | pass |\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| second | <= 1 | share 3 |  | short |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| no goal |  | median 12.5 ms |  |  |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("## Errors"), std::string::npos);
  EXPECT_EQ(text.find("## Errors"), text.rfind("## Errors")) << "one table a section";
  EXPECT_NE(text.find("## Time"), std::string::npos);
}

TEST(Report, JsonHoldsEveryNumber) {
  const auto json = nlohmann::json::parse(toJson(sample()));
  EXPECT_EQ(json["suite"], "demo");
  EXPECT_EQ(json["machine"]["processor"], "a | processor");
  EXPECT_EQ(json["seed"], 7);
  ASSERT_EQ(json["rows"].size(), 3U);
  EXPECT_EQ(json["rows"][0]["name"], "bars | and\nlines");
  EXPECT_EQ(json["rows"][0]["measured"][0]["value"], 0.123456);
  EXPECT_TRUE(json["rows"][0]["references"][0]["value"].is_null());
  EXPECT_EQ(json["rows"][0]["pass"], true);
  EXPECT_EQ(json["rows"][1]["pass"], false);
  EXPECT_TRUE(json["rows"][2]["pass"].is_null());
}

TEST(Report, BytesThatAreNoTextDoNotBreakJson) {
  Report report = sample();
  report.machine.processor = "caf\xe9";
  EXPECT_TRUE(nlohmann::json::accept(toJson(report)));
}

TEST(Report, IsWrittenBesideEachOther) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(writeReport(folder.path(), sample()));
  EXPECT_TRUE(std::filesystem::exists(folder / "demo.md"));
  EXPECT_TRUE(std::filesystem::exists(folder / "demo.json"));
}

TEST(Report, NumbersAreShort) {
  EXPECT_EQ(shortNumber(0.0123456), "0.0123");
  EXPECT_EQ(shortNumber(30000), "30000");
  EXPECT_EQ(shortNumber(0.0), "0");
  EXPECT_EQ(shortNumber(std::nan("")), "-");
}

}  // namespace
}  // namespace mirrorarm::benchmarks
