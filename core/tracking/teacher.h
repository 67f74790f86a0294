#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include "core/common/expected.h"
#include "core/tracking/softassign.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking {

struct TeacherSettings {
  SoftassignSettings softassign;
  double max_rms_m = 0.003;   ///< frames that fit worse are left out
  double min_presence = 0.5;  ///< share of the frames in which a point must be seen to become a marker
  double marker_diameter_m = 0.007;
};

/// Why nothing could be taught; the operator can mend each.
/// kNoFrames: nothing was added; kTooFewMarkers: fewer than 3 were seen often enough; kCollinear: they lie on
/// a line.
enum class TeachingError { kNoFrames, kTooFewMarkers, kCollinear };
/// "no_frames", "too_few_markers", "collinear".
[[nodiscard]] std::string_view id(TeachingError error);

struct TaughtTarget {
  Target target;
  int frames_used = 0;
  int frames_rejected = 0;
  double sigma_m =
      0.0;  ///< largest standard deviation of a taught marker position; 0 when one frame was used
};

/// Learns a target from one or many clouds while the arm moves and markers are hidden. Frame T: axes of the
/// camera at the first cloud, origin at the taught markers' centroid (of the first cloud, when it shows just
/// them). Every later cloud is registered to the model, updates the running mean and scatter of each marker
/// and may add markers; clouds that do not fit are left out, strangers that are seen too seldom are dropped
/// at the end, as is a point nearer to a better seen marker than the markers' diameter. Points that are not
/// finite are ignored; of one cloud at most kMaxPoints are considered. One cloud suffices: positions are then
/// known, their covariance is not. Source: paper section 2.3.6. One thread.
class Teacher {
 public:
  explicit Teacher(const TeacherSettings& settings);
  ~Teacher();
  Teacher(Teacher&&) noexcept;
  Teacher& operator=(Teacher&&) noexcept;

  /// Adds one measured cloud (camera frame) [m].
  void add(std::span<const Eigen::Vector3d> cloud_C);
  [[nodiscard]] int frames() const;
  /// Markers that finish() would keep so far.
  [[nodiscard]] int markers() const;

  [[nodiscard]] Expected<TaughtTarget, TeachingError> finish(std::string_view name) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
