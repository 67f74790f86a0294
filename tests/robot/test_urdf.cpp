#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/common/scratch_folder.h"
#include "tests/robot/arms.h"
#include "tests/robot/mutations.h"

namespace mirrorarm::robot {
namespace {

using testing::withInstead;

constexpr double kDeg = std::numbers::pi / 180.0;

std::string textOf(const std::string& name) {
  return testing::textOf(std::string(RESOURCES) + "/robots/" + name + ".urdf");
}

FromFile<ArmDescription> readText(const std::string& xml) {
  const test::ScratchFolder folder;
  return readUrdf(folder.holding("arm.urdf", xml));
}

std::string chain(const std::string& joint, const std::string& more = "") {
  return R"(<robot name="r"><link name="a"/><link name="b"/>)" + more + joint + "</robot>";
}

const std::string kGood = R"(<joint name="j" type="revolute"><parent link="a"/><child link="b"/>
  <axis xyz="0 0 2"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>)";

std::string refusalOf(const std::string& xml) {
  const auto read = readText(xml);
  return read ? "accepted" : read.error().reason;
}

}  // namespace

TEST(Urdf, LbrHasTheTablesLimits) {
  const ArmDescription lbr = testing::lbr();
  ASSERT_EQ(lbr.jointCount(), 7);
  const char* names[] = {"A1", "A2", "E1", "A3", "A4", "A5", "A6"};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(lbr.joints[i].name, names[i]);
    EXPECT_NEAR(lbr.joints[i].upper_rad, (i % 2 == 0 ? 170 : 120) * kDeg, 1e-5);
    EXPECT_NEAR(lbr.joints[i].lower_rad, -lbr.joints[i].upper_rad, 1e-12);
  }
  EXPECT_NEAR(lbr.joints[0].max_speed_rad_s, 110 * kDeg, 1e-5);
  EXPECT_NEAR(lbr.joints[4].max_speed_rad_s, 180 * kDeg, 1e-5);
  EXPECT_NEAR(lbr.joints[5].max_torque_nm, 30.0, 1e-12);
}

TEST(Urdf, IiwasHaveTheTablesLimits) {
  const double speeds_deg_s[2][7] = {{98, 98, 100, 130, 140, 180, 180}, {85, 85, 100, 75, 130, 135, 135}};
  const double ends_deg[7] = {170, 120, 170, 120, 170, 120, 175};
  for (const int which : {0, 1}) {
    const ArmDescription iiwa = testing::arm(which == 0 ? "iiwa7" : "iiwa14");
    ASSERT_EQ(iiwa.jointCount(), 7);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_NEAR(iiwa.joints[i].upper_rad, ends_deg[i] * kDeg, 1e-6);
      EXPECT_EQ(iiwa.joints[i].lower_rad, -iiwa.joints[i].upper_rad);
      EXPECT_NEAR(iiwa.joints[i].max_speed_rad_s, speeds_deg_s[which][i] * kDeg, 1e-6);
    }
  }
}

TEST(Urdf, EveryLinkHasAShapeOnItsLink) {
  for (const char* name : {"lbr4plus", "iiwa7", "iiwa14", "ur5"}) {
    const ArmDescription arm = testing::arm(name);
    ASSERT_EQ(arm.shapes.size(), arm.joints.size() + 1) << name;
    for (int link = 0; link <= arm.jointCount(); ++link)
      EXPECT_EQ(arm.shapes[static_cast<std::size_t>(link)].link, link) << name;
  }
}

TEST(Urdf, CylinderBecomesTheCapsuleAroundItsAxis) {
  const Capsule upper_arm = testing::arm("ur5").shapes[2];
  EXPECT_NEAR((upper_arm.b - upper_arm.a).norm(), 0.425, 1e-9);
  EXPECT_NEAR(std::abs((upper_arm.b - upper_arm.a).normalized().x()), 1.0, 1e-9);
  EXPECT_NEAR(upper_arm.radius_m, 0.055, 1e-12);
}

TEST(Urdf, FixedJointsAreFoldedIn) {
  const auto read = readText(chain(kGood, R"(<link name="c"/><joint name="f" type="fixed"><parent link="b"/>
    <child link="c"/><origin xyz="0 0 0.3" rpy="0 0 0"/></joint>)"));
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->jointCount(), 1);
  EXPECT_NEAR(read->X_last_F.translation().z(), 0.3, 1e-12);
  EXPECT_NEAR(read->joints[0].axis.norm(), 1.0, 1e-12);
}

TEST(Urdf, RefusesWithFileAndReason) {
  const auto missing = readUrdf("/nowhere/arm.urdf");
  ASSERT_FALSE(missing);
  EXPECT_EQ(describe(missing.error()), "/nowhere/arm.urdf: is missing");
  const auto slide =
      readText(withInstead(textOf("lbr4plus"), R"("E1" type="revolute")", R"("E1" type="prismatic")"));
  ASSERT_FALSE(slide);
  EXPECT_EQ(slide.error().reason, "joint 'E1': only revolute and fixed joints can be used");
  EXPECT_EQ(slide.error().line, 42);
  EXPECT_NE(refusalOf("this is no XML"), "accepted");
  EXPECT_NE(refusalOf(""), "accepted");
  EXPECT_NE(refusalOf(textOf("lbr4plus").substr(0, 1500)), "accepted");
  EXPECT_NE(refusalOf(chain("")), "accepted");
}

TEST(Urdf, RefusesWhatIsNoChainOfTurningJoints) {
  EXPECT_EQ(refusalOf(chain(kGood)), "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "revolute", "prismatic"))).find("'j'"), std::string::npos);
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "revolute", "floating"))), "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "revolute", "continuous"))), "accepted");
  EXPECT_NE(
      refusalOf(chain(withInstead(kGood, R"(<limit lower="-1" upper="1" velocity="1" effort="1"/>)", ""))),
      "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, R"(upper="1")", R"(upper="-2")"))), "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, R"(velocity="1")", R"(velocity="0")"))), "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "0 0 2", "0 0 0"))), "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "0 0 2", "0 nan 1"))), "accepted");
  EXPECT_NE(refusalOf(chain(kGood, R"(<link name="c"/>)" +
                                       withInstead(withInstead(kGood, "\"b\"", "\"c\""), "\"j\"", "\"k\""))),
            "accepted");
}

TEST(Urdf, RefusesWhatDoesNotHangTogether) {
  const std::string back = withInstead(
      withInstead(withInstead(kGood, "\"j\"", "\"k\""), R"(<parent link="a"/>)", R"(<parent link="b"/>)"),
      R"(<child link="b"/>)", R"(<child link="a"/>)");
  EXPECT_NE(refusalOf(chain(kGood, back)), "accepted") << "a ring";
  const std::string ring_below =
      R"(<link name="c"/><link name="d"/>)" +
      withInstead(withInstead(withInstead(kGood, "\"j\"", "\"k\""), "\"a\"", "\"c\""), "\"b\"", "\"d\"") +
      withInstead(withInstead(withInstead(kGood, "\"j\"", "\"l\""), "\"a\"", "\"d\""), "\"b\"", "\"c\"");
  EXPECT_NE(refusalOf(chain(kGood, ring_below)), "accepted") << "a ring beside the arm";
  const std::string fixed_ring = R"(<link name="c"/>
    <joint name="f" type="fixed"><parent link="b"/><child link="c"/></joint>
    <joint name="g" type="fixed"><parent link="c"/><child link="b"/></joint>)";
  EXPECT_NE(refusalOf(chain(kGood, fixed_ring)), "accepted") << "a ring at the end of the arm";
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "\"b\"", "\"a\""))), "accepted") << "a link that bears itself";
  EXPECT_NE(refusalOf(chain(kGood, R"(<link name="alone"/>)")), "accepted") << "two roots";
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "\"b\"", "\"ghost\""))), "accepted") << "an unknown child";
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "\"a\"", "\"ghost\""))), "accepted") << "an unknown parent";
  EXPECT_NE(refusalOf(chain(kGood, kGood)), "accepted") << "a name used twice";
  const std::string nan_limit = refusalOf(chain(withInstead(kGood, R"(lower="-1")", R"(lower="nan")")));
  EXPECT_NE(nan_limit, "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, "<axis", R"(<origin xyz="0 nan 0"/><axis)"))), "accepted");
  EXPECT_NE(refusalOf(chain(withInstead(kGood, R"(effort="1")", R"(effort="inf")"))), "accepted");
}

TEST(Urdf, RefusesMoreJointsThanThereIsRoomFor) {
  const auto quoted = [](char letter, int number) {
    return std::string{'"', letter, static_cast<char>('0' + number), '"'};
  };
  std::ostringstream xml;
  xml << R"(<robot name="snake"><link name="l0"/>)";
  for (int i = 0; i <= kMaxJoints; ++i) {
    const std::string joint = withInstead(kGood, "\"j\"", quoted('j', i));
    xml << "<link name=" << quoted('l', i + 1) << "/>"
        << withInstead(withInstead(joint, "\"a\"", quoted('l', i)), "\"b\"", quoted('l', i + 1));
  }
  xml << "</robot>";
  EXPECT_NE(refusalOf(xml.str()).find("more than 8"), std::string::npos);
}

TEST(Urdf, RefusesCollisionShapesItCannotUse) {
  const std::string box =
      R"(<link name="b"><collision><geometry><box size="1 1 1"/></geometry></collision></link>)";
  EXPECT_NE(refusalOf(withInstead(chain(kGood), R"(<link name="b"/>)", box)).find("neither"),
            std::string::npos);
}

TEST(Urdf, SurvivesMutations) {
  testing::forMutationsOf(textOf("lbr4plus"), 700, [](const std::string& text) {
    const auto read = readText(text);
    if (read) {
      EXPECT_GT(read->jointCount(), 0);
    } else {
      EXPECT_EQ(read.error().reason.find('\n'), std::string::npos);
    }
  });
}

}  // namespace mirrorarm::robot
