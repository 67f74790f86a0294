#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/camera/stereo_frame.h"
#include "core/camera/stereo_rig.h"
#include "core/common/file_error.h"
#include "core/robot/joints.h"

namespace mirrorarm::devices {

/// A recording folder, opened for reading: rig.yaml and frames.csv are read and checked at once, images when
/// they are asked for. A value; one thread.
class Recording {
 public:
  /// Refused: a missing or wrong rig.yaml or frames.csv, frames out of order, no frame at all.
  [[nodiscard]] static FromFile<Recording> open(const std::filesystem::path& folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const camera::StereoRig& rig() const { return rig_; }
  [[nodiscard]] std::size_t size() const { return frames_.size(); }
  /// Value of the column `index` of frame `i`.
  [[nodiscard]] long long index(std::size_t i) const { return frames_[i].index; }
  /// Middle of the exposure of frame `i`, as the file says.
  [[nodiscard]] TimePoint exposedAt(std::size_t i) const { return fromNanoseconds(frames_[i].time_ns); }
  /// Frame `i` with both images, times from the file. Refused: an image that is missing, broken or not of the
  /// rig's size.
  [[nodiscard]] FromFile<camera::StereoFrame> frame(std::size_t i) const;

 private:
  struct Reader;
  struct Entry {
    long long index = 0;
    long long time_ns = 0;
    double exposure_us = 0.0;
    std::filesystem::path left;
    std::filesystem::path right;
  };
  std::filesystem::path folder_;
  camera::StereoRig rig_;
  std::vector<Entry> frames_;
};

/// Where a target truly was in one frame, for simulated recordings.
struct TruthRow {
  long long index = 0;
  std::string target;
  RigidTransform X_CT = RigidTransform::Identity();  ///< in the left camera
  int visible = 0;                                   ///< markers that both cameras see
};

/// Writes a recording folder frame by frame; it appears under its name when finish() is called, or not at
/// all.
class RecordingWriter {
 public:
  /// The error is why the folder cannot be made; one that holds a recording already is refused.
  [[nodiscard]] static Expected<RecordingWriter, std::string> create(const std::filesystem::path& folder,
                                                                     const camera::StereoRig& rig);
  ~RecordingWriter();
  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;

  /// Frames in the order of their sequence; the images are written at once.
  [[nodiscard]] Expected<void, std::string> add(const camera::StereoFrame& frame);
  void addTruth(const TruthRow& row);
  /// A row of robot.csv; every row of a recording has equally many joints.
  void addFlange(TimePoint time, const robot::Joints& q_rad, const RigidTransform& X_BF);
  /// Where the recording grows until it is finished: place for files beside the frames, for example
  /// target.yaml.
  [[nodiscard]] std::filesystem::path stagingFolder() const;
  /// Writes the tables and gives the folder its name. Once, last.
  [[nodiscard]] Expected<void, std::string> finish();

 private:
  RecordingWriter();
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::devices
