#include <random>

#include <gtest/gtest.h>

#include "core/common/yaml.h"
#include "tests/common/scratch_folder.h"

using namespace mirrorarm;
using test::ScratchFolder;

namespace {

struct Settings {
  double gain = 0.0;
  long long count = 0;
  std::string name;
  bool active = false;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  std::vector<double> list;
};

FromFile<Settings> readSettings(const std::filesystem::path& file) {
  return readYaml(file, "mirrorarm/test/1", [](const YamlNode& root) {
    root.allowOnly({"format", "gain", "count", "name", "active", "pose", "list"});
    Settings settings;
    settings.gain = root["gain"].number();
    settings.count = root["count"].integer();
    settings.name = root["name"].text();
    if (root.has("active")) settings.active = root["active"].flag();
    settings.shift = root["pose"]["shift"].vector3();
    settings.turn = root["pose"]["turn"].quaternion();
    settings.list = root["list"].numbers();
    return settings;
  });
}

const std::string kGood =
    "format: mirrorarm/test/1\n"
    "gain: 2.5\n"
    "count: 7\n"
    "name: arm\n"
    "active: true\n"
    "pose:\n"
    "  shift: [1, 2, 3]\n"
    "  turn: [0, 0, 0.7071, 0.7071]\n"
    "list: [1, 2]\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kGood;
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST(Yaml, ReadsWhatIsThere) {
  const ScratchFolder folder;
  const auto read = readSettings(folder.holding("s.yaml", kGood));
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->gain, 2.5);
  EXPECT_EQ(read->count, 7);
  EXPECT_EQ(read->name, "arm");
  EXPECT_TRUE(read->active);
  EXPECT_EQ(read->shift, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(read->turn.norm(), 1.0, 1e-12);
  EXPECT_EQ(read->list.size(), 2u);
}

TEST(Yaml, RefusesWithTheLineAndTheKeysFullName) {
  struct Case {
    std::string text, key;
    int line;
  };
  const Case cases[] = {
      {with("gain: 2.5", "gain: fast"), "gain", 2},
      {with("gain: 2.5", "gain: .inf"), "gain", 2},
      {with("count: 7", "count: 7.5"), "count", 3},
      {with("active: true", "active: maybe"), "active", 5},
      {with("active: true", "colour: red"), "colour", 5},
      {with("[1, 2, 3]", "[1, 2]"), "pose.shift", 7},
      {with("0.7071]", "7]"), "pose.turn", 8},
      {with("  turn", "  twist"), "pose.turn is missing", 7},
      {with("list: [1, 2]", "list: [1, b]"), "list[1]", 9},
      {with("list: [1, 2]", "list: 1"), "list", 9},
      {with("test/1", "test/2"), "mirrorarm/test/1", 1},
  };
  const ScratchFolder folder;
  for (const auto& c : cases) {
    const auto read = readSettings(folder.holding("s.yaml", c.text));
    ASSERT_FALSE(read) << c.text;
    EXPECT_NE(read.error().reason.find(c.key), std::string::npos) << describe(read.error());
    EXPECT_EQ(read.error().line, c.line) << describe(read.error());
  }
  EXPECT_EQ(readSettings(folder.path() / "absent.yaml").error().reason, "cannot be read");
  EXPECT_FALSE(readSettings(folder.holding("s.yaml", "")));
  EXPECT_FALSE(readSettings(folder.holding("s.yaml", "- 1\n- 2\n")));
  EXPECT_FALSE(readSettings(folder.holding("s.yaml", "a: [1, 2\nb: }")));
}

TEST(Yaml, BrokenBytesAreRefusedOrReadNeverWorse) {
  const ScratchFolder folder;
  std::mt19937 rng(2);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> at(0, kGood.size() - 1);
  for (int trial = 0; trial < 400; ++trial) {
    std::string broken = kGood;
    for (int change = 0; change <= trial % 4; ++change) broken[at(rng)] = static_cast<char>(byte(rng));
    if (trial % 3 == 0) broken.resize(at(rng));
    const auto read = readSettings(folder.holding("s.yaml", broken));
    EXPECT_TRUE(read || !read.error().reason.empty());
  }
}
