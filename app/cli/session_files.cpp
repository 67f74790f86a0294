#include "app/cli/session_files.h"

#include "core/common/atomic_file.h"
#include "core/common/time.h"
#include "core/tracking/pose_file.h"

namespace mirrorarm::cli {
namespace {

TimePoint timeOf(const therapy::Sample& sample) { return TimePoint(toClock(Seconds(sample.time_s))); }

void writePose(std::ostream& out, const RigidTransform& X) {
  const auto q = rotationOf(X);
  for (const double value :
       {X.translation().x(), X.translation().y(), X.translation().z(), q.x(), q.y(), q.z(), q.w()})
    out << ',' << value;
}

tracking::PoseRow rowOf(long long index, const therapy::Sample& sample) {
  tracking::PoseRow row{index, "forearm", {}, {}};
  row.answer.status = sample.status;
  row.answer.X_CT = sample.X_CT;
  row.answer.exposed_at = timeOf(sample);
  row.answer.rms_m = sample.rms_m;
  row.answer.matched_count = sample.matched;
  row.answer.covariance.diagonal().head<3>().setConstant(sample.sigma_r_rad * sample.sigma_r_rad);
  row.answer.covariance.diagonal().tail<3>().setConstant(sample.sigma_t_m * sample.sigma_t_m);
  return row;
}

}  // namespace

Expected<void, std::string> writePoses(const std::filesystem::path& file,
                                       std::span<const therapy::Sample> samples) {
  std::vector<tracking::PoseRow> rows;
  for (const auto& sample : samples) rows.push_back(rowOf(static_cast<long long>(rows.size()), sample));
  return tracking::writePoses(file, rows);
}

Expected<void, std::string> writeRobot(const std::filesystem::path& file,
                                       std::span<const therapy::Sample> samples, const RigidTransform& X_FE) {
  return writeWhole(file, [&](std::ostream& out) {
    const auto joints = samples.empty() ? 0 : samples.front().q_rad.size();
    out << "time_ns";
    for (Eigen::Index joint = 1; joint <= joints; ++joint) out << ",q" << joint;
    out << ",tx_m,ty_m,tz_m,qx,qy,qz,qw\n";
    for (const auto& sample : samples) {
      out << toNanoseconds(timeOf(sample));
      for (const double q : sample.q_rad) out << ',' << q;
      writePose(out, sample.X_BE * X_FE.inverse());
      out << '\n';
    }
  });
}

}  // namespace mirrorarm::cli
