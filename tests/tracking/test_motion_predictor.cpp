#include <fstream>

#include <gtest/gtest.h>

#include "core/simulation/trc_file.h"
#include "core/tracking/motion_predictor.h"
#include "tests/common/no_heap.h"
#include "tests/tracking/arm_motions.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

// In multiples of the noise of a pose from a good rig: 6 amounts to 0.1 mm along the line of sight.
constexpr double kFine = 1.0;
constexpr double kCoarse = 6.0;
constexpr double kSeen_s = 1.0 / 24.0;  // a rest is seen after so long: by the second pose of 24 Hz

/// Largest errors of a stop, each at 20, 50 and 100 ms ahead.
struct StopErrors {
  std::array<double, 3> foretold{}, held{};  ///< over the whole manoeuvre [m]
  std::array<double, 3> excess_at_rest{};    ///< of the prediction over holding, once the rest is seen
};

void judgeStop(const Motion& motion, double rest_from_s, double rate_hz, unsigned seed, double noise_scale,
               StopErrors& errors) {
  PoseNoise sensor(seed, noise_scale);
  MotionPredictor predictor;
  for (double t = 0.0; t < rest_from_s + 0.6; t += 1.0 / rate_hz) {
    const UncertainPose seen = sensor.measure(motion(t));
    predictor.add(atSecond(t), seen);
    if (t < 0.4) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double ahead = Foretold::kAhead_s[k];
      const double error = shiftError(predictor.at(atSecond(t + ahead)).X_CT, motion(t + ahead));
      const double held = shiftError(seen.X_CT, motion(t + ahead));
      errors.foretold[k] = std::max(errors.foretold[k], error);
      errors.held[k] = std::max(errors.held[k], held);
      if (t >= rest_from_s + kSeen_s)
        errors.excess_at_rest[k] = std::max(errors.excess_at_rest[k], error - held);
    }
  }
}

/// Poses of a forearm on skin markers, recorded at 100 Hz; empty when the file is absent.
std::vector<UncertainPose> realForearm() {
  const std::array<std::string_view, 10> names{"EPICl",    "EPICm", "LARMm",    "LARMl", "LARM_elb",
                                               "LARM_ant", "STYLr", "STYLr_up", "STYLu", "WRIST"};
  const auto motion =
      simulation::readTrc(std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb/markers.trc", names);
  std::vector<UncertainPose> poses;
  if (!motion) return poses;
  std::vector<MarkerMatch> matches(names.size());
  Vector3d middle = Vector3d::Zero();
  for (const auto& p : motion->positions_m[0]) middle += p / static_cast<double>(names.size());
  PoseEstimator estimator;
  RigidTransform X_CT = makeTransform(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), middle);
  for (const auto& frame : motion->positions_m) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      matches[i].marker_T = motion->positions_m[0][i] - middle;
      matches[i].point_C = frame[i];
    }
    const auto& estimate = estimator.estimate(matches, X_CT);
    X_CT = estimate.X_CT;
    poses.push_back({estimate.X_CT, estimate.covariance});
  }
  return poses;
}

/// What prediction and holding were wrong by.
struct Judged {
  double foretold = 0.0, held = 0.0;  ///< sums of squares [m^2]
  [[nodiscard]] double ratio() const { return std::sqrt(foretold / held); }
};

/// Errors `ahead` samples after each `every`-th.
void judgeRecording(const std::vector<UncertainPose>& poses, double step_s, std::size_t every,
                    std::size_t ahead, Judged& judged) {
  MotionPredictor predictor;
  for (std::size_t i = 0; i + ahead < poses.size(); i += every) {
    predictor.add(atSecond(step_s * static_cast<double>(i)), poses[i]);
    if (i < 5 * every) continue;
    const auto at = predictor.at(atSecond(step_s * static_cast<double>(i + ahead)));
    judged.foretold += std::pow(shiftError(at.X_CT, poses[i + ahead].X_CT), 2);
    judged.held += std::pow(shiftError(poses[i].X_CT, poses[i + ahead].X_CT), 2);
  }
}

/// A hand's reaches on a table, cut where the recording leaps. Empty when it is absent.
std::vector<std::vector<UncertainPose>> realReaches(const char* name) {
  constexpr double kMetrePerPixel = 0.0003;
  constexpr double kLeap_m = 0.06;
  std::ifstream in(std::filesystem::path(SHARED_DATA) / "reach-to-target" / name);
  std::vector<std::vector<UncertainPose>> segments;
  std::string rest_of_line;
  std::getline(in, rest_of_line);
  UncertainPose pose;
  pose.covariance.diagonal() << Vector3d::Constant(1e-7), Vector3d::Constant(1e-8);
  for (double x_px = 0.0, y_px = 0.0; in >> x_px >> y_px && std::getline(in, rest_of_line);) {
    pose.X_CT.translation() << kMetrePerPixel * x_px, kMetrePerPixel * y_px, 0.4;
    if (segments.empty() || shiftError(pose.X_CT, segments.back().back().X_CT) > kLeap_m)
      segments.emplace_back();
    segments.back().push_back(pose);
  }
  return segments;
}

}  // namespace

TEST(MotionPredictor, ForetellsAnArmsSwing) {
  const auto slow = foretell(swing(0.7, 0.12), 24.0, kFine);
  EXPECT_LT(slow.rms_mm(0), 0.16);
  EXPECT_LT(slow.rms_mm(1), 0.75);
  EXPECT_LT(slow.rms_mm(2), 3.1);
  const auto fast = foretell(swing(0.7, 0.12), 120.0, kFine);
  EXPECT_LT(fast.rms_mm(0), 0.04);  // noise of the poses: 0.018 alone
  EXPECT_LT(fast.rms_mm(1), 0.24);
  EXPECT_LT(fast.rms_mm(2), 1.6);
}

TEST(MotionPredictor, OtherMotionsAreForetoldFarBetterThanHeld) {
  for (const double rate_hz : {24.0, 120.0})
    for (const double noise : {kFine, kCoarse})
      for (const Motion& motion :
           {swing(0.4, 0.15), swing(0.55, 0.12), swing(0.85, 0.12), swing(1.2, 0.08), Motion(reaches)}) {
        const auto result = foretell(motion, rate_hz, noise);
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_LT(result.rms_mm(k), 0.15 * result.heldRms_mm(k)) << rate_hz << " Hz, " << k;
      }
}

TEST(MotionPredictor, CovarianceIsNotTooSmall) {
  for (const double rate_hz : {24.0, 120.0})
    for (const double noise : {kFine, kCoarse})
      for (const Motion& motion : {swing(0.4, 0.15), swing(0.7, 0.12), swing(0.85, 0.12), swing(1.2, 0.08),
                                   swing(2.0, 0.03), Motion(reaches)}) {
        const auto result = foretell(motion, rate_hz, noise);
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_LT(result.meanNees(k), 1.2 * 6.0) << rate_hz << " Hz, noise " << noise << ", " << k;
      }
}

// A stop at any time between two frames. No method can know of a sudden one before it is seen: until then the
// error is at most what holding was wrong by all along. A frame of 24 Hz later the prediction is no further
// off than the last pose itself, but for noise.
TEST(MotionPredictor, StopsAreNeverWorseThanHoldingTheLastPose) {
  for (const double rate_hz : {24.0, 120.0})
    for (const double noise : {kFine, kCoarse}) {
      StopErrors sudden, smooth;
      for (unsigned i = 0; i < 60; ++i) {
        const double stop_s = 0.9 + i / (60.0 * rate_hz);
        judgeStop(suddenStop(stop_s), stop_s, rate_hz, i, noise, sudden);
        judgeStop(smoothStop(stop_s, 0.3), stop_s + 0.3, rate_hz, i, noise, smooth);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LT(sudden.foretold[k], 1.02 * sudden.held[k] + 17e-6 * noise) << rate_hz << " " << noise;
        EXPECT_LT(smooth.foretold[k], smooth.held[k]) << rate_hz << " " << noise;
        for (const auto& stop : {sudden, smooth})
          EXPECT_LT(stop.excess_at_rest[k], std::max(5.0 * 17e-6 * noise, 0.04 * stop.held[k]))
              << rate_hz << " " << noise << " " << k;
      }
    }
}

TEST(MotionPredictor, StaysCalmAtRest) {
  for (const double rate_hz : {24.0, 120.0}) {
    const auto result = foretell([](double) { return alongPath(0.3); }, rate_hz, kCoarse);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(result.rms_mm(k), result.heldRms_mm(k));
  }
}

TEST(MotionPredictor, FramesMayBeLostAndLate) {
  Noise noise(9);
  PoseNoise sensor(8, kFine);
  MotionPredictor predictor;
  const Motion motion = swing(0.7, 0.12);
  double sum = 0.0;
  int count = 0;
  for (double t = 0.0; t < 20.0; t += 1.0 / 24.0 + noise.uniform(-0.006, 0.006)) {
    if (noise.uniform(0.0, 1.0) < 0.2) continue;
    predictor.add(atSecond(t), sensor.measure(motion(t)));
    if (t < 0.5) continue;
    sum += std::pow(shiftError(predictor.at(atSecond(t + 0.05)).X_CT, motion(t + 0.05)), 2);
    ++count;
  }
  EXPECT_LT(std::sqrt(sum / count), 0.0005);
}

TEST(MotionPredictor, ForetellsARealForearm) {
  const auto poses = realForearm();
  if (poses.empty()) GTEST_SKIP() << "shared data pyomeca-upper-limb is absent";
  for (const std::size_t every : {1U, 4U})
    for (const std::size_t ahead : {2U, 5U, 10U}) {
      Judged judged;
      judgeRecording(poses, 0.01, every, ahead, judged);
      EXPECT_LT(judged.ratio(), 0.4) << every << " " << ahead;
    }
}

TEST(MotionPredictor, ForetellsRealReaches) {
  for (const char* name : {"ap01-1.dat", "cp01-1.dat", "pp01-1.dat"}) {
    const auto segments = realReaches(name);
    if (segments.empty()) GTEST_SKIP() << "shared data reach-to-target is absent";
    for (const std::size_t ahead : {1U, 2U, 3U}) {
      Judged judged;
      for (const auto& segment : segments) judgeRecording(segment, 0.03, 1, ahead, judged);
      EXPECT_LT(judged.ratio(), 0.9) << name << " " << ahead;
    }
  }
}

TEST(MotionPredictor, AnswersBeforeTheLastPoseToo) {
  const Motion motion = swing(0.7, 0.12);
  PoseNoise sensor(3, kFine);
  MotionPredictor predictor;
  for (int i = 0; i <= 48; ++i) predictor.add(atSecond(i / 24.0), sensor.measure(motion(i / 24.0)));
  for (const double t : {2.0 - 1.0 / 24.0, 1.99, 2.0})
    EXPECT_LT(errorOf(predictor.at(atSecond(t)).X_CT, motion(t)).norm(), 0.002) << t;
}

TEST(MotionPredictor, BeginsAnewAfterALongGapOrAStepBack) {
  MotionPredictor predictor;
  EXPECT_FALSE(predictor.isKnown());
  PoseNoise sensor(4, kFine);
  for (int i = 0; i < 24; ++i) predictor.add(atSecond(i / 24.0), sensor.measure(alongPath(0.05 * i)));
  EXPECT_EQ(predictor.lastMeasured(), atSecond(23.0 / 24.0));
  EXPECT_NEAR(predictor.ageAt(atSecond(1.0)).count(), 1.0 / 24.0, 1e-6);
  EXPECT_EQ(predictor.ageAt(atSecond(0.0)).count(), 0.0);
  for (const double later : {2.0, 1.5}) {
    predictor.add(atSecond(later), sensor.measure(alongPath(0.0)));
    EXPECT_LT(shiftError(predictor.at(atSecond(later + 0.1)).X_CT, alongPath(0.0)), 1e-4);
    EXPECT_GT(predictor.at(atSecond(later + 0.1)).covariance(3, 3), 0.02 * 0.02);
  }
  predictor.forget();
  EXPECT_FALSE(predictor.isKnown());
}

TEST(MotionPredictor, TakesNothingFromTheHeap) {
  if (!mirrorarm::testing::heapIsCounted) GTEST_SKIP() << "a sanitizer brings its own heap";
  MotionPredictor predictor;
  PoseNoise sensor(5, kFine);
  const auto calls = mirrorarm::testing::heapCallsIn([&] {
    for (int i = 0; i < 10; ++i) {
      predictor.add(atSecond(i / 24.0), sensor.measure(alongPath(0.01 * i)));
      (void)predictor.at(atSecond(i / 24.0 + 0.05));
    }
  });
  EXPECT_EQ(calls, 0U);
}
