#include <cerrno>
#include <pthread.h>
#include <sched.h>
#include <thread>

#include <gtest/gtest.h>

#include "core/devices/real_time.h"

namespace mirrorarm::devices {
namespace {

TEST(RealTime, SaysWhatWasGrantedAndIsSo) {
  std::thread([] {
    const RealTimeGrant grant = askForRealTime();
    int policy = 0;
    sched_param parameters{};
    ASSERT_EQ(::pthread_getschedparam(::pthread_self(), &policy, &parameters), 0);
    EXPECT_EQ(policy == SCHED_FIFO, grant.scheduling_error == 0);
    if (grant.scheduling_error == 0) {
      EXPECT_EQ(parameters.sched_priority, kServoPriority);
    }
  }).join();
}

TEST(RealTime, ARefusalNamesItsReasonAndTheCure) {
  const RealTimeGrant refused{EPERM, ENOMEM};
  EXPECT_FALSE(refused.isFull());
  EXPECT_NE(schedulingLine(refused).find("rtprio"), std::string::npos);
  EXPECT_NE(memoryLine(refused).find("memlock"), std::string::npos);
  EXPECT_TRUE(RealTimeGrant{}.isFull());
}

TEST(RealTime, APriorityThatDoesNotExistIsRefused) {
  std::thread([] { EXPECT_NE(askForRealTime(1000).scheduling_error, 0); }).join();
}

}  // namespace
}  // namespace mirrorarm::devices
