#include "app/cli/session_files.h"

#include "core/common/atomic_file.h"
#include "core/common/time.h"

namespace mirrorarm::cli {
namespace {

long long nanoseconds(const therapy::Sample& sample) { return toNanoseconds(TimePoint(toClock(Seconds(sample.time_s)))); }

void writePose(std::ostream& out, const RigidTransform& X) {
  const auto q = rotationOf(X);
  for (const double value : {X.translation().x(), X.translation().y(), X.translation().z(), q.x(), q.y(), q.z(), q.w()})
    out << ',' << value;
}

}  // namespace

Expected<void, std::string> writePoses(const std::filesystem::path& file, std::span<const therapy::Sample> samples) {
  return writeWhole(file, [&](std::ostream& out) {
    out << "index,time_ns,target,status,tx_m,ty_m,tz_m,qx,qy,qz,qw,rms_m,matched,sigma_t_m,sigma_r_rad\n";
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto& sample = samples[i];
      out << i << ',' << nanoseconds(sample) << ",forearm," << id(sample.status);
      if (sample.status == tracking::TrackStatus::kLost) {
        out << ",,,,,,,,,,,\n";
        continue;
      }
      writePose(out, sample.X_CT);
      out << ',' << sample.rms_m << ',' << sample.matched << ",,\n";
    }
  });
}

Expected<void, std::string> writeRobot(const std::filesystem::path& file, std::span<const therapy::Sample> samples) {
  return writeWhole(file, [&](std::ostream& out) {
    const auto joints = samples.empty() ? 0 : samples.front().q_rad.size();
    out << "time_ns";
    for (Eigen::Index joint = 1; joint <= joints; ++joint) out << ",q" << joint;
    out << ",tx_m,ty_m,tz_m,qx,qy,qz,qw\n";
    for (const auto& sample : samples) {
      out << nanoseconds(sample);
      for (const double q : sample.q_rad) out << ',' << q;
      writePose(out, sample.X_BE);
      out << '\n';
    }
  });
}

}  // namespace mirrorarm::cli
