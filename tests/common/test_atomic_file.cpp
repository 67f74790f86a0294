#include <ostream>

#include <gtest/gtest.h>

#include "core/common/atomic_file.h"
#include "tests/common/scratch_folder.h"

using namespace mirrorarm;
using test::bytesOf;
using test::ScratchFolder;

namespace {

std::ptrdiff_t filesIn(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

}  // namespace

TEST(AtomicFile, WritesAndReplacesAndMakesFolders) {
  const ScratchFolder folder;
  const auto file = folder.path() / "a" / "b" / "out.csv";
  ASSERT_TRUE(writeWhole(file, [](std::ostream& out) { out << "first"; }));
  ASSERT_TRUE(writeWhole(file, [](std::ostream& out) { out << "second"; }));
  EXPECT_EQ(bytesOf(file), "second");
  EXPECT_EQ(filesIn(file.parent_path()), 1);
}

TEST(AtomicFile, NumbersComeBackBitForBit) {
  const ScratchFolder folder;
  const auto file = folder.path() / "n.txt";
  ASSERT_TRUE(writeWhole(file, [](std::ostream& out) { out << 0.1 + 0.2; }));
  EXPECT_EQ(std::stod(bytesOf(file)), 0.1 + 0.2);
}

TEST(AtomicFile, AFailureLeavesTheOldFileAndNothingElse) {
  const ScratchFolder folder;
  const auto file = folder.holding("out.csv", "old");
  const auto written = writeWhole(file, [](std::ostream& out) {
    out << "half of the n";
    out.setstate(std::ios::badbit);
  });
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().find("out.csv"), std::string::npos);
  EXPECT_EQ(bytesOf(file), "old");
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
  const ScratchFolder folder;
  const auto plain = folder.holding("plain", "a file, not a folder");
  EXPECT_FALSE(writeWhole(plain / "out.csv", [](std::ostream& out) { out << "x"; }));
  std::filesystem::create_directories(folder.path() / "taken" / "inside");
  const auto onto_folder = writeWhole(folder.path() / "taken", [](std::ostream& out) { out << "x"; });
  ASSERT_FALSE(onto_folder);
  EXPECT_NE(onto_folder.error().find("taken"), std::string::npos);
  EXPECT_EQ(filesIn(folder.path()), 2);
}
