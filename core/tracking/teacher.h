#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/common/expected.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/softassign.h"
#include "core/tracking/target.h"

namespace mirrorarm::tracking {

struct TeacherSettings {
  SoftassignSettings softassign{};
  double max_rms_m = 0.003;   ///< frames that fit worse are left out
  double min_presence = 0.5;  ///< share of the frames in which a point must be seen to become a marker
  double marker_diameter_m = 0.007;
  double wanted_sigma_m = 0.01e-3;  ///< of every marker's position: the lesson is then done
  int min_frames = 50;              ///< that it takes at least
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
  /// Largest standard deviation of a taught marker position, in its least sure direction; 0 when it is not
  /// known: one frame of points without covariance.
  double sigma_m = 0.0;
  /// For each marker how far it moves against the others, standard deviation per axis beyond what the sensor
  /// explains [m]; 0 for one that does not. Where the sensor's covariance is not known the quiet markers tell
  /// it.
  std::vector<double> skin_sigma_m;
};

/// Learns a target from one or many clouds while the arm moves and markers are hidden. Frame T: axes of the
/// camera at the first cloud that was used, origin at the taught markers' centroid. Every later cloud is
/// registered to what is known so far, and may add markers; clouds that do not fit are left out. When more
/// clouds in a row do not fit than fitted before, the lesson begins anew with the next one.
///
/// Left out at the end are strangers seen too seldom, points that do not move with the body, ghosts of rival
/// stereo pairs (what shares a disc with a better seen point, else with an earlier one of the cloud) and
/// points nearer to a better seen marker than the markers' diameter. Positions and covariances come from a
/// free-network bundle adjustment over up to Keyframes::kMax frames: see BundleAdjustment.
///
/// Points that are not finite are ignored; of one cloud at most kMaxPoints are considered. One cloud
/// suffices. Time of add() is bounded: some tenths of a millisecond, some milliseconds when the precision is
/// looked at, ever more seldom. Source: paper section 2.3.6. One thread.
class Teacher {
 public:
  explicit Teacher(const TeacherSettings& settings);
  ~Teacher();
  Teacher(Teacher&&) noexcept;
  Teacher& operator=(Teacher&&) noexcept;

  /// Adds one measured cloud (camera frame).
  void add(std::span<const CloudPoint> cloud);
  /// The same where the sensor's covariance is not known [m]: residuals will tell it.
  void add(std::span<const Eigen::Vector3d> cloud_C);

  [[nodiscard]] int frames() const;
  /// Markers that finish() would keep so far.
  [[nodiscard]] int markers() const;
  /// Largest standard deviation of a marker position so far [m]; infinite as long as it is not known.
  [[nodiscard]] double sigma_m() const;
  /// True when the wanted precision is reached.
  [[nodiscard]] bool isDone() const;

  [[nodiscard]] Expected<TaughtTarget, TeachingError> finish(std::string_view name) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::tracking
