#include "core/calibration/hand_eye_convention.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/calibration/contradicting_stations.h"
#include "core/calibration/median.h"
#include "core/calibration/station_misfit.h"
#include "core/calibration/tsai_lenz.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kClearlyBetter = 3.0;
constexpr double kLargestMedian_m = 0.02;  ///< of a reading that is believed
constexpr double kAgreeing_m = 0.001;      ///< as given; few stations may by chance agree better otherwise
constexpr double kArm_m = 0.3;             ///< at which a turn counts as a shift

enum class Reading { kAsGiven, kInverted, kScalarFirst };

/// A rotation whose quaternion was written w, x, y, z and read x, y, z, w.
RigidTransform scalarFirst(const RigidTransform& X) {
  const Eigen::Quaterniond q = rotationOf(X);
  return makeTransform(Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()), X.translation());
}

RigidTransform readAs(Reading reading, const RigidTransform& X) {
  switch (reading) {
    case Reading::kAsGiven:
      return X;
    case Reading::kInverted:
      return X.inverse();
    case Reading::kScalarFirst:
      break;
  }
  return scalarFirst(X);
}

struct Agreement {
  double median_m = std::numeric_limits<double>::infinity();
  bool has_camera_nearer = false;  ///< to what carries it than the object to what carries that
};

/// How well robot and camera agree when read so, in the manner of a camera in the hand.
Agreement agreementOf(std::span<const PosePair> pairs, CameraMount mount, Reading robot, Reading camera) {
  std::vector<PosePair> read;
  for (const auto& pair : pairs) {
    const RigidTransform X_BF = readAs(robot, pair.X_BF);
    read.push_back({mount == CameraMount::kInHand ? X_BF : X_BF.inverse(), readAs(camera, pair.X_CM)});
  }
  const auto contradicting = contradictingStations(read);
  std::vector<double> weights(read.size(), 1.0);
  for (const auto station : contradicting) weights[station] = 0.0;
  const auto X_FC = tsaiLenzOverAllPairs(read, weights);
  if (!X_FC) return {};
  const auto misfit = stationMisfit(read, *X_FC, weights);
  return {median(misfit.position_m) + kArm_m * median(misfit.rotation_rad),
          X_FC->translation().norm() < misfit.X_BM.translation().norm()};
}

HandEyeError invertedOrElsewhere(CameraMount mount, bool has_camera_nearer) {
  if (mount == CameraMount::kInHand)
    return has_camera_nearer ? HandEyeError::kRobotInverted : HandEyeError::kCameraBesideRobot;
  return has_camera_nearer ? HandEyeError::kCameraInHand : HandEyeError::kRobotInverted;
}

struct Suspicion {
  Reading robot;
  Reading camera;
  HandEyeError error;
};

constexpr std::array kSuspicions = {
    Suspicion{Reading::kInverted, Reading::kAsGiven, HandEyeError::kRobotInverted},
    Suspicion{Reading::kAsGiven, Reading::kInverted, HandEyeError::kCameraInverted},
    Suspicion{Reading::kInverted, Reading::kInverted, HandEyeError::kBothInverted},
    Suspicion{Reading::kScalarFirst, Reading::kAsGiven, HandEyeError::kRobotScalarFirst},
    Suspicion{Reading::kAsGiven, Reading::kScalarFirst, HandEyeError::kCameraScalarFirst},
    Suspicion{Reading::kScalarFirst, Reading::kScalarFirst, HandEyeError::kBothScalarFirst},
};

}  // namespace

std::optional<HandEyeError> wrongConvention(std::span<const PosePair> pairs, CameraMount mount) {
  const auto given = agreementOf(pairs, mount, Reading::kAsGiven, Reading::kAsGiven);
  if (given.median_m < kAgreeing_m) return std::nullopt;
  double least_m = std::min(kLargestMedian_m, given.median_m / kClearlyBetter);
  std::optional<HandEyeError> found;
  for (const auto& [robot, camera, error] : kSuspicions) {
    const auto agreement = agreementOf(pairs, mount, robot, camera);
    if (!(agreement.median_m < least_m)) continue;
    least_m = agreement.median_m;
    found = error == HandEyeError::kRobotInverted ? invertedOrElsewhere(mount, agreement.has_camera_nearer)
                                                  : error;
  }
  return found;
}

}  // namespace mirrorarm::calibration
