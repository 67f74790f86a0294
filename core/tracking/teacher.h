#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/common/expected.h"
#include "core/tracking/softassign.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking {

struct TeacherSettings {
  SoftassignSettings softassign;
  double max_rms_m = 0.003;         ///< frames that fit worse are left out
  double min_presence = 0.5;        ///< share of the frames in which a point must be seen to become a marker
  double marker_diameter_m = 0.007;
};

/// Why nothing could be taught; the operator can mend each.
enum class TeachingError { kNoFrames, kTooFewMarkers, kCollinear };
/// "no_frames", "too_few_markers", "collinear".
[[nodiscard]] std::string_view id(TeachingError error);

struct TaughtTarget {
  Target target;
  int frames_used = 0;
  int frames_rejected = 0;
  double sigma_m = 0.0;  ///< largest standard deviation of a taught marker position
};

/// Learns a target from one or many clouds while the arm moves and markers are hidden. Frame T: axes of the
/// camera at the first cloud, origin at its centroid. Every later cloud is registered to the model, updates the
/// running mean of each marker and may add markers; strangers that are seen too seldom are dropped at the end.
/// Source: paper section 2.3.6. One thread.
class Teacher {
 public:
  explicit Teacher(const TeacherSettings& settings);
  ~Teacher();

  /// Adds one measured cloud (camera frame) [m].
  void add(std::span<const Eigen::Vector3d> cloud_C);
  [[nodiscard]] int frames() const;
  /// Markers so far.
  [[nodiscard]] int markers() const;

  [[nodiscard]] Expected<TaughtTarget, TeachingError> finish(std::string_view name) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
