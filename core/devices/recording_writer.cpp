#include <array>
#include <cassert>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "core/camera/image_file.h"
#include "core/camera/rig_file.h"
#include "core/common/atomic_file.h"
#include "core/devices/recording.h"

namespace mirrorarm::devices {
namespace {

using Written = Expected<void, std::string>;

constexpr int kDigits = 12;

std::string poseCells(const RigidTransform& X) {
  std::ostringstream cells;
  const auto p = X.translation();
  const auto q = rotationOf(X);
  cells << std::setprecision(kDigits) << p.x() << ',' << p.y() << ',' << p.z() << ',' << q.x() << ',' << q.y()
        << ',' << q.z() << ',' << q.w();
  return cells.str();
}

std::string imageName(const char* side, std::uint64_t sequence) {
  std::array<char, 48> name{};
  std::snprintf(name.data(), name.size(), "%s/%06llu.png", side, static_cast<unsigned long long>(sequence));
  return name.data();
}

std::string robotHeader(long joints) {
  std::string header = "time_ns";
  for (long i = 1; i <= joints; ++i) header += ",q" + std::to_string(i);
  return header + ",tx_m,ty_m,tz_m,qx,qy,qz,qw\n";
}

Written writeText(const std::filesystem::path& file, const std::string& text) {
  return writeWhole(file, [&text](std::ostream& out) { out << text; });
}

}  // namespace

struct RecordingWriter::Body {
  std::filesystem::path folder;
  std::filesystem::path staging;
  std::string frames = "index,time_ns,exposure_us,left,right\n";
  std::string truth;
  std::string robot;
  long joints = 0;

  ~Body() {
    std::error_code ignored;
    if (!staging.empty()) std::filesystem::remove_all(staging, ignored);
  }
};

RecordingWriter::RecordingWriter() : body_(std::make_unique<Body>()) {}
RecordingWriter::~RecordingWriter() = default;
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;

Expected<RecordingWriter, std::string> RecordingWriter::create(const std::filesystem::path& folder,
                                                               const camera::StereoRig& rig) {
  std::error_code failed;
  const bool empty =
      std::filesystem::is_directory(folder, failed) && std::filesystem::is_empty(folder, failed);
  if (std::filesystem::exists(folder, failed) && !empty)
    return unexpected(folder.string() + " exists and is not an empty folder");
  RecordingWriter writer;
  writer.body_->folder = std::filesystem::absolute(folder).lexically_normal();
  if (!writer.body_->folder.has_filename()) writer.body_->folder = writer.body_->folder.parent_path();
  auto staging = writer.body_->folder;
  staging += ".unfinished";
  std::filesystem::remove_all(staging, failed);
  if (!std::filesystem::create_directories(staging / "left", failed) ||
      !std::filesystem::create_directories(staging / "right", failed))
    return unexpected(staging.string() + " cannot be made: " + failed.message());
  writer.body_->staging = staging;
  if (auto written = camera::writeRig(staging / "rig.yaml", rig); !written)
    return unexpected(written.error());
  return writer;
}

std::filesystem::path RecordingWriter::stagingFolder() const { return body_->staging; }

Written RecordingWriter::add(const camera::StereoFrame& frame) {
  const auto left = imageName("left", frame.sequence), right = imageName("right", frame.sequence);
  if (auto written = camera::writeImage(body_->staging / left, frame.left); !written) return written;
  if (auto written = camera::writeImage(body_->staging / right, frame.right); !written) return written;
  std::ostringstream row;
  row << std::setprecision(kDigits) << frame.sequence << ',' << toNanoseconds(frame.exposed_at) << ','
      << frame.exposure.count() * 1e6 << ',' << left << ',' << right << '\n';
  body_->frames += row.str();
  return {};
}

void RecordingWriter::addTruth(const TruthRow& row) {
  if (body_->truth.empty()) body_->truth = "index,target,tx_m,ty_m,tz_m,qx,qy,qz,qw,visible\n";
  body_->truth += std::to_string(row.index) + ',' + row.target + ',' + poseCells(row.X_CT) + ',' +
                  std::to_string(row.visible) + '\n';
}

void RecordingWriter::addFlange(TimePoint time, const robot::Joints& q_rad, const RigidTransform& X_BF) {
  if (body_->robot.empty()) {
    body_->joints = q_rad.size();
    body_->robot = robotHeader(body_->joints);
  }
  assert(q_rad.size() == body_->joints);
  std::ostringstream row;
  row << toNanoseconds(time) << std::setprecision(kDigits);
  for (const double angle : q_rad) row << ',' << angle;
  body_->robot += row.str() + ',' + poseCells(X_BF) + '\n';
}

Written RecordingWriter::finish() {
  const auto& staging = body_->staging;
  if (auto written = writeText(staging / "frames.csv", body_->frames); !written) return written;
  if (!body_->truth.empty())
    if (auto written = writeText(staging / "truth.csv", body_->truth); !written) return written;
  if (!body_->robot.empty())
    if (auto written = writeText(staging / "robot.csv", body_->robot); !written) return written;
  std::error_code failed;
  std::filesystem::remove(body_->folder, failed);
  std::filesystem::rename(staging, body_->folder, failed);
  if (failed) return unexpected(body_->folder.string() + " cannot be made: " + failed.message());
  body_->staging.clear();
  return {};
}

}  // namespace mirrorarm::devices
