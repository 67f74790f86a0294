#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include <CLI/App.hpp>

#include "core/camera/stereo_rig.h"
#include "core/common/time.h"
#include "core/vision/finder_settings.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::cli {

/// Where points are taken from; one is given, or none where a command has another source.
struct PointInput {
  std::filesystem::path recording;
  std::filesystem::path clouds;
  vision::CentreMethod method = vision::FinderSettings{}.method;  ///< for a recording
};

/// How many inputs a command takes.
enum class Inputs { kOne, kAtMostOne };
/// The positional REC and the options --clouds and --method of a command.
void addPointInput(CLI::App& command, PointInput& input, Inputs inputs = Inputs::kOne);

/// The points of one frame.
struct PointFrame {
  long long index = 0;
  TimePoint exposed_at{};
  std::vector<vision::StereoPoint> points;
  double vision_ms = 0.0;  ///< from the images to the points; 0 where no image was
};

/// Measured points frame by frame.
class PointSource {
 public:
  virtual ~PointSource() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Frame `i`; throws InputRefused.
  [[nodiscard]] virtual PointFrame frame(std::size_t i) = 0;
  /// The cameras that saw the points; null where that is not known.
  [[nodiscard]] virtual const camera::StereoRig* rig() const { return nullptr; }
};

/// Opens what `input` names; throws InputRefused.
[[nodiscard]] std::unique_ptr<PointSource> openPoints(const PointInput& input);

}  // namespace mirrorarm::cli
