#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/calibration/candidate_views.h"
#include "core/calibration/next_view.h"
#include "core/calibration/view_information.h"
#include "core/camera/stereo_view.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

const Board kBoard{BoardKind::kCircles, 9, 7, 0.03};

bool always(const RigidTransform&) { return true; }

double tilt_rad(const RigidTransform& X_CM) {
  const Eigen::Vector3d middle_C = X_CM * Eigen::Vector3d(0.12, 0.09, 0.0);
  return std::acos(X_CM.linear().col(2).dot(middle_C.normalized()));
}

/// Standard deviations of a rig's numbers after views at `poses`.
Eigen::VectorXd sigmas(const camera::StereoRig& rig, std::span<const RigidTransform> poses) {
  const auto points = boardPoints(kBoard);
  const RigInformation information(rig, points);
  Eigen::MatrixXd known = information.prior();
  for (const auto& X_CM : poses) known += information.of(X_CM);
  return known.inverse().diagonal().cwiseSqrt();
}

TEST(NextView, CandidatesAreSeenByBothCamerasAndSpread) {
  for (const auto model : {camera::LensModel::kBrownConrady, camera::LensModel::kKannalaBrandt}) {
    const auto rig = trueRig(model);
    const auto points = boardPoints(kBoard);
    const auto candidates = candidateViews(rig, points, 0);
    ASSERT_GT(candidates.size(), 40u);
    double most_tilt = 0.0;
    for (const auto& X_CM : candidates) {
      int seen = 0;
      for (const auto& p_M : points) seen += camera::bothCamerasSee(rig, X_CM * p_M) ? 1 : 0;
      EXPECT_GE(seen, 50);
      EXPECT_LT(tilt_rad(X_CM), 0.75);
      most_tilt = std::max(most_tilt, tilt_rad(X_CM));
    }
    EXPECT_GT(most_tilt, 0.6);
    EXPECT_FALSE(candidates.front().isApprox(candidateViews(rig, points, 1).front()));
  }
}

TEST(NextView, WhatIsProposedTeachesMoreThanWhatAPersonDoes) {
  const auto rig = trueRig(camera::LensModel::kKannalaBrandt);
  std::vector<RigidTransform> proposed;
  double last_gain = 1e9;
  for (int i = 0; i < 10; ++i) {
    const auto wish = nextStereoView(rig, kBoard, proposed, always);
    ASSERT_TRUE(wish);
    EXPECT_LT(wish->gain, 1.3 * last_gain);  // every next view has less to tell
    last_gain = wish->gain;
    proposed.push_back(wish->X_CM);
  }
  ViewMaker person{rig, kBoard};
  std::vector<RigidTransform> at_random;
  for (int i = 0; i < 10; ++i) at_random.push_back(person.boardPose());
  const auto points = boardPoints(kBoard);
  const RigInformation information(rig, points);
  const auto ours = sigmas(rig, proposed), theirs = sigmas(rig, at_random);
  EXPECT_LT(ours.array().log().mean(), theirs.array().log().mean() - 0.2);
}

TEST(NextView, OnlyWhatIsReachableIsProposed) {
  const auto rig = trueRig(camera::LensModel::kKannalaBrandt);
  const auto near = [](const RigidTransform& X_CM) { return X_CM.translation().z() < 0.4; };
  const auto wish = nextStereoView(rig, kBoard, {}, near);
  ASSERT_TRUE(wish);
  EXPECT_LT(wish->X_CM.translation().z(), 0.4);
  const auto never = [](const RigidTransform&) { return false; };
  EXPECT_FALSE(nextStereoView(rig, kBoard, {}, never));
  EXPECT_FALSE(nextHandEyeView(rig, kBoard, {}, never));
}

TEST(NextView, HandEyeStationsTurnAboutTwoAxes) {
  const auto rig = trueRig(camera::LensModel::kKannalaBrandt);
  std::vector<RigidTransform> taken;
  for (int i = 0; i < 6; ++i) {
    const auto wish = nextHandEyeView(rig, kBoard, taken, always);
    ASSERT_TRUE(wish);
    taken.push_back(wish->X_CM);
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& a : taken)
    for (const auto& b : taken) {
      const Eigen::Vector3d turn = rotationVector((a * b.inverse()).linear());
      scatter += turn * turn.transpose() / 36.0;
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  EXPECT_GT(std::sqrt(axes.eigenvalues()[1]), 0.3);
}

}  // namespace
}  // namespace mirrorarm::calibration
