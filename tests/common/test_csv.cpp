#include <array>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "tests/common/scratch_folder.h"

using namespace mirrorarm;
using test::ScratchFolder;

TEST(Csv, ReadsCellsWithoutBlanksAndRemembersLines) {
  const ScratchFolder folder;
  const auto table = CsvTable::read(folder.holding("t.csv", "a, b ,c\r\n1,  two,3.5\r\n\r\n , ,-1e-3\n"));
  ASSERT_TRUE(table) << describe(table.error());
  ASSERT_EQ(table->header().size(), 3u);
  EXPECT_EQ(table->header()[1], "b");
  ASSERT_EQ(table->rows().size(), 2u);
  EXPECT_EQ(table->rows()[0].cells[1], "two");
  EXPECT_EQ(table->rows()[1].line, 4);
  EXPECT_EQ(table->column("c"), 2);
  EXPECT_EQ(table->column("d"), -1);
  EXPECT_EQ(*table->number(table->rows()[1], 2), -1e-3);
  EXPECT_EQ(*table->integer(table->rows()[0], 0), 1);
}

TEST(Csv, RefusesWithPlaceAndReason) {
  const ScratchFolder folder;
  EXPECT_EQ(CsvTable::read(folder.path() / "absent.csv").error().reason, "cannot be read");
  EXPECT_FALSE(CsvTable::read(folder.path()));
  EXPECT_NE(CsvTable::read(folder.holding("empty.csv", "")).error().reason.find("header"), std::string::npos);
  const auto ragged = CsvTable::read(folder.holding("ragged.csv", "a,b\n1,2\n1,2,3\n"));
  ASSERT_FALSE(ragged);
  EXPECT_EQ(ragged.error().line, 3);

  const auto table = CsvTable::read(folder.holding("t.csv", "a,b\n1,x\n1.5,nan\n"));
  ASSERT_TRUE(table);
  const std::array<std::string_view, 2> wanted{"a", "z"};
  EXPECT_NE(table->columns(wanted).error().reason.find("z"), std::string::npos);
  const auto word = table->number(table->rows()[0], 1);
  ASSERT_FALSE(word);
  EXPECT_EQ(word.error().line, 2);
  EXPECT_NE(word.error().reason.find("b"), std::string::npos);
  EXPECT_FALSE(table->number(table->rows()[1], 1));
  EXPECT_FALSE(table->integer(table->rows()[1], 0));
}

TEST(Csv, TakesNumbersWholeAndFiniteOrNotAtAll) {
  double number = 0.0;
  EXPECT_TRUE(parseNumber("-2.5e3", number));
  EXPECT_EQ(number, -2500.0);
  for (const auto* text : {"", "1,5", "1.5 ", "2x", "nan", "inf", "1e999", "0x10", "--1"})
    EXPECT_FALSE(parseNumber(text, number)) << text;
}

TEST(Csv, BrokenBytesAreRefusedOrReadNeverWorse) {
  const ScratchFolder folder;
  const std::string whole = "index,x_m\n0,0.5\n1,0.6\n2,-7e-2\n";
  std::mt19937 rng(1);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> at(0, whole.size() - 1);
  for (int trial = 0; trial < 400; ++trial) {
    std::string broken = whole;
    for (int change = 0; change <= trial % 4; ++change) broken[at(rng)] = static_cast<char>(byte(rng));
    if (trial % 3 == 0) broken.resize(at(rng));
    const auto table = CsvTable::read(folder.holding("t.csv", broken));
    if (!table) continue;
    for (const auto& row : table->rows()) {
      ASSERT_EQ(row.cells.size(), table->header().size());
      for (int column = 0; column < static_cast<int>(row.cells.size()); ++column)
        (void)table->number(row, column);
    }
  }
}
