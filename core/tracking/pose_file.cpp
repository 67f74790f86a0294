#include "core/tracking/pose_file.h"

#include <ostream>

#include "core/common/atomic_file.h"

namespace mirrorarm::tracking {
namespace {

constexpr int kNumbersOfPose = 11;

void writePose(std::ostream& out, const TrackedTarget& answer) {
  const Eigen::Vector3d p = answer.X_CT.translation();
  const Eigen::Quaterniond q = rotationOf(answer.X_CT);
  out << ',' << p.x() << ',' << p.y() << ',' << p.z() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
      << q.w() << ',' << answer.rms_m << ',' << answer.matched_count << ',' << shiftSigma(answer) << ','
      << turnSigma(answer);
}

}  // namespace

Expected<void, std::string> writePoses(const std::filesystem::path& file, std::span<const PoseRow> rows) {
  return writeWhole(file, [rows](std::ostream& out) {
    out << "index,time_ns,target,status,tx_m,ty_m,tz_m,qx,qy,qz,qw,rms_m,matched,sigma_t_m,sigma_r_rad\n";
    for (const auto& row : rows) {
      out << row.index << ',' << toNanoseconds(row.answer.exposed_at) << ',' << row.target << ','
          << id(row.answer.status);
      if (row.answer.status == TrackStatus::kLost) {
        out << std::string(kNumbersOfPose, ',');
      } else {
        writePose(out, row.answer);
      }
      out << '\n';
    }
  });
}

Expected<void, std::string> writeMatches(const std::filesystem::path& file, std::span<const PoseRow> rows) {
  return writeWhole(file, [rows](std::ostream& out) {
    out << "index,target,marker,x_m,y_m,z_m\n";
    for (const auto& row : rows) {
      auto point = row.points_C.begin();
      for (int marker = 0; marker < row.answer.marker_count; ++marker) {
        if (row.answer.point_of_marker[static_cast<std::size_t>(marker)] < 0) continue;
        out << row.index << ',' << row.target << ',' << marker << ',' << point->x() << ',' << point->y()
            << ',' << point->z() << '\n';
        ++point;
      }
    }
  });
}

}  // namespace mirrorarm::tracking
