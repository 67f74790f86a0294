#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "core/common/atomic_file.h"
#include "core/common/time.h"
#include "core/devices/pose_receiver.h"

namespace mirrorarm::cli {
namespace {

using devices::ReceivedPose;

constexpr Seconds kConnectPatience{5.0};
constexpr Seconds kBeat{0.2};

struct Wish {
  std::string address;
  std::string tool;
  std::string out;
  double seconds = 10.0;
};

/// By this computer's clock too: the sender may give no time.
struct TimedPose {
  double received_s = 0.0;
  ReceivedPose pose;
};

std::vector<TimedPose> listen(devices::PoseReceiver& receiver, const Wish& wish) {
  std::vector<TimedPose> poses;
  const TimePoint start = Clock::now();
  while (secondsBetween(start, Clock::now()) < wish.seconds) {
    const auto received = receiver.receive(kBeat);
    if (!received) throw CommandFailed(wish.address + ": " + received.error());
    for (const auto& pose : *received)
      if (wish.tool.empty() || pose.name == wish.tool)
        poses.push_back({secondsBetween(start, Clock::now()), pose});
  }
  return poses;
}

void write(std::ostream& out, const std::vector<TimedPose>& poses) {
  out << "time_s,received_s,tool,tx_m,ty_m,tz_m,qx,qy,qz,qw\n";
  for (const auto& [received_s, pose] : poses) {
    const Eigen::Vector3d p = pose.X.translation();
    const auto q = rotationOf(pose.X);
    out << (pose.time_s > 0.0 ? pose.time_s : received_s) << ',' << received_s << ',' << pose.name << ','
        << p.x() << ',' << p.y() << ',' << p.z() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
        << q.w() << '\n';
  }
}

void run(const Wish& wish, Context& context) {
  const auto address = devices::hostAddressOf(wish.address, devices::kIgtlPort);
  if (!address) throw InputRefused(address.error());
  auto receiver = devices::PoseReceiver::connect(*address, kConnectPatience);
  if (!receiver) throw CommandFailed(receiver.error());
  const auto poses = listen(*receiver, wish);
  if (poses.empty())
    throw CommandFailed(wish.address + ": no pose" + (wish.tool.empty() ? "" : " of '" + wish.tool + "'") +
                        " came");
  orFail(writeWhole(wish.out, [&](std::ostream& out) { write(out, poses); }));
  const auto& sights = receiver->sights();
  context.result["poses"] = poses.size();
  context.result["told"] = {{"tracked", sights[0]}, {"predicted", sights[1]}, {"lost", sights[2]}};
  if (!context.json) std::cout << poses.size() << " poses written to " << wish.out << "\n";
}

}  // namespace

void addListen(CLI::App& app, Context& context) {
  CLI::App* command = addCommand(
      app, context, "listen", "Record the poses that another tracker sends over OpenIGTLink",
      "mirrorarm-cli listen 192.168.1.5:18944 --tool FlangeToTracker --seconds 60 --out truth.csv");
  const auto wish = std::make_shared<Wish>();
  command->add_option("address", wish->address, "HOST:PORT of the tracker")->required();
  command->add_option("--tool", wish->tool, "Only poses of this name");
  command->add_option("--seconds", wish->seconds, "How long")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  command->add_option("--out", wish->out, "The table of poses to write")->required();
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
