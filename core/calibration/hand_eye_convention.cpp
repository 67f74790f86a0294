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
constexpr double kLargestMedian_m = 0.04;  ///< of a reading that is believed
constexpr double kAgreeing_m = 0.001;      ///< as given; few stations may by chance agree better otherwise
constexpr double kArm_m = 0.3;             ///< at which a turn counts as a shift
constexpr double kOnFlange_m = 0.3;        ///< what rides on a flange may be that far from it

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

/// How well robot and camera agree when read so, in the manner of a camera in the hand, and where that puts
/// the camera on what carries it and the object on the other.
struct Agreement {
  double median_m = std::numeric_limits<double>::infinity();
  double camera_m = 0.0;
  double object_m = 0.0;
};

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
  return {median(misfit.position_m) + kArm_m * median(misfit.rotation_rad), X_FC->translation().norm(),
          misfit.X_BM.translation().norm()};
}

/// What rides on the flange is nearer to it than what stands beside the robot is to its base.
bool hasTheWrongOneOnTheFlange(const Agreement& agreement, CameraMount mount) {
  const bool in_hand = mount == CameraMount::kInHand;
  const double on_flange_m = in_hand ? agreement.camera_m : agreement.object_m;
  const double beside_m = in_hand ? agreement.object_m : agreement.camera_m;
  return on_flange_m > beside_m && on_flange_m > kOnFlange_m;
}

/// An object in the camera lies before it.
bool areInFront(std::span<const PosePair> pairs, Reading camera) {
  return std::all_of(pairs.begin(), pairs.end(), [camera](const PosePair& pair) {
    return readAs(camera, pair.X_CM).translation().z() > 0.0;
  });
}

/// Robot and camera agree once the robot is inverted. So they do when the camera is inverted, or carried by
/// the other one: then the solution has camera and object in each other's place.
HandEyeError otherWayRound(std::span<const PosePair> pairs, CameraMount mount, const Agreement& inverted) {
  if (!hasTheWrongOneOnTheFlange(inverted, mount)) return HandEyeError::kRobotInverted;
  if (!areInFront(pairs, Reading::kAsGiven) || areInFront(pairs, Reading::kInverted))
    return HandEyeError::kCameraInverted;
  return mount == CameraMount::kInHand ? HandEyeError::kCameraBesideRobot : HandEyeError::kCameraInHand;
}

struct Suspicion {
  Reading robot;
  Reading camera;
  HandEyeError error;
};

constexpr std::array kSuspicions = {
    Suspicion{Reading::kInverted, Reading::kAsGiven, HandEyeError::kRobotInverted},
    Suspicion{Reading::kScalarFirst, Reading::kAsGiven, HandEyeError::kRobotScalarFirst},
    Suspicion{Reading::kAsGiven, Reading::kScalarFirst, HandEyeError::kCameraScalarFirst},
    Suspicion{Reading::kScalarFirst, Reading::kScalarFirst, HandEyeError::kBothScalarFirst},
};

/// The reading that is clearly better than as given, if any.
std::optional<HandEyeError> betterReading(std::span<const PosePair> pairs, CameraMount mount,
                                          double given_m) {
  double least_m = std::min(kLargestMedian_m, given_m / kClearlyBetter);
  std::optional<HandEyeError> found;
  for (const auto& [robot, camera, error] : kSuspicions) {
    const auto agreement = agreementOf(pairs, mount, robot, camera);
    if (!(agreement.median_m < least_m)) continue;
    least_m = agreement.median_m;
    found = error == HandEyeError::kRobotInverted ? otherWayRound(pairs, mount, agreement) : error;
  }
  return found;
}

}  // namespace

std::optional<HandEyeError> wrongConvention(std::span<const PosePair> pairs, CameraMount mount) {
  const auto given = agreementOf(pairs, mount, Reading::kAsGiven, Reading::kAsGiven);
  if (!(given.median_m < kAgreeing_m))
    if (const auto found = betterReading(pairs, mount, given.median_m)) return found;
  // Inverted both ways they agree as well, with camera and object in each other's place.
  if (given.median_m < kLargestMedian_m && hasTheWrongOneOnTheFlange(given, mount))
    return HandEyeError::kBothInverted;
  return std::nullopt;
}

}  // namespace mirrorarm::calibration
