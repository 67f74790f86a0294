#include <gtest/gtest.h>

#include "core/devices/robot_address.h"

namespace mirrorarm::devices {
namespace {

TEST(RobotAddress, IsAWordForEachKindOfRobot) {
  EXPECT_EQ(robotAddressOf("simulated")->kind, RobotAddress::Kind::kSimulated);
  const auto fri = robotAddressOf("fri:192.168.0.100:49938");
  ASSERT_TRUE(fri) << fri.error();
  EXPECT_EQ(fri->kind, RobotAddress::Kind::kFri);
  EXPECT_EQ(fri->at.host, "192.168.0.100");
  EXPECT_EQ(robotAddressOf("fri:49939")->at.host, "127.0.0.1");
  EXPECT_EQ(robotAddressOf("fri:49939")->at.port, 49939);
  EXPECT_EQ(robotAddressOf("igtl:robot.local")->at.port, 18944);
  for (const auto* wrong : {"", "kuka", "fri", "fri:", "fri:x", "fri:1.2.3.4:0", "igtl:", "igtl:h:99999"}) {
    const auto refused = robotAddressOf(wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_NE(refused.error().find("igtl:HOST[:PORT]"), std::string::npos);
  }
}

TEST(RobotAddress, OpensWhatItNames) {
  FriLinkSettings fri;
  const auto elsewhere = openRobot(*robotAddressOf("fri:192.0.2.1:49938"), fri, Seconds(0.2));
  ASSERT_FALSE(elsewhere);
  EXPECT_NE(elsewhere.error().find("192.0.2.1"), std::string::npos);
  EXPECT_FALSE(openRobot(*robotAddressOf("igtl:127.0.0.1:1"), fri, Seconds(0.2)));
}

}  // namespace
}  // namespace mirrorarm::devices
