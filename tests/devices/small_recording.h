#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>

#include "core/devices/recording.h"

namespace mirrorarm::devices {

/// A folder of its own under the temporary one, gone with the object.
class OwnFolder {
 public:
  OwnFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("mirrorarm_recording_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~OwnFolder() { std::filesystem::remove_all(path_); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline camera::StereoRig smallRig() {
  const camera::CameraModel camera({camera::LensModel::kBrownConrady, 16, 12, 20.0, 20.0, 7.5, 5.5, {}});
  return {camera, camera, makeTransform(Eigen::Matrix3d::Identity(), {-0.12, 0.0, 0.0}), {}};
}

inline camera::GreyImage smallImage(std::uint8_t first) {
  std::vector<std::uint8_t> pixels(16 * 12);
  for (auto& pixel : pixels) pixel = first++;
  return {16, 12, std::move(pixels)};
}

/// Frame `i` of a 24 Hz recording whose frame 2 was lost.
inline camera::StereoFrame smallFrame(int i) {
  const auto sequence = static_cast<std::uint64_t>(i < 2 ? i : i + 1);
  return {smallImage(static_cast<std::uint8_t>(i)), smallImage(static_cast<std::uint8_t>(100 + i)),
          fromNanoseconds(5'000'000'000 + static_cast<long long>(sequence) * 41'666'667), Seconds(0.0015),
          sequence};
}

/// Writes `frames` of them to `folder`.
inline Expected<void, std::string> writeSmall(const std::filesystem::path& folder, int frames) {
  auto writer = RecordingWriter::create(folder, smallRig());
  if (!writer) return unexpected(writer.error());
  for (int i = 0; i < frames; ++i)
    if (auto added = writer->add(smallFrame(i)); !added) return added;
  return writer->finish();
}

}  // namespace mirrorarm::devices
