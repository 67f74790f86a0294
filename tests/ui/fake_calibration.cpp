#include "tests/ui/fake_calibration.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::ui::test {
namespace {

using station::CalibrationAction;
using station::CalibrationPhase;

using Pixels = std::vector<std::uint8_t>;

void paintDisc(Pixels& pixels, const camera::Intrinsics& camera, const Eigen::Vector2d& centre,
               double radius) {
  for (int y = static_cast<int>(centre.y() - radius); y <= centre.y() + radius; ++y)
    for (int x = static_cast<int>(centre.x() - radius); x <= centre.x() + radius; ++x)
      if (x >= 0 && y >= 0 && x < camera.width_px && y < camera.height_px &&
          (Eigen::Vector2d(x, y) - centre).norm() < radius)
        pixels[static_cast<std::size_t>(y) * camera.width_px + x] = 225;
}

/// One camera's picture of the plate and where its points are.
std::pair<camera::GreyImage, calibration::Sighting> look(const camera::CameraModel& camera,
                                                         const calibration::Board& board,
                                                         const RigidTransform& X_KM) {
  const auto& numbers = camera.intrinsics();
  Pixels pixels(static_cast<std::size_t>(numbers.width_px) * numbers.height_px, 16);
  calibration::Sighting seen;
  const auto points_M = calibration::boardPoints(board);
  const auto diameters_m = calibration::discDiameters_m(board);
  for (std::size_t i = 0; i < points_M.size(); ++i) {
    const Eigen::Vector3d point_K = X_KM * points_M[i];
    const auto pixel = camera.project(point_K);
    const double radius = diameters_m[i] / 2 * numbers.fx_px / point_K.z();
    if (!pixel || !camera.sees(*pixel, radius)) continue;
    seen.push_back({static_cast<int>(i), *pixel, 0.02, Eigen::Matrix2d::Zero()});
    paintDisc(pixels, numbers, *pixel, radius);
  }
  return {camera::GreyImage(numbers.width_px, numbers.height_px, std::move(pixels)), std::move(seen)};
}

calibration::BoardShape flatBoard() {
  calibration::BoardShape shape;
  shape.flatness_rms_m = 21e-6;
  shape.flatness_sigma_m = 19e-6;
  shape.stretch_percent = 0.004;
  shape.stretch_sigma_percent = 0.006;
  return shape;
}

void addToCoverage(const calibration::BoardView& view, const camera::Intrinsics& camera, int views,
                   calibration::Coverage& coverage) {
  constexpr int kCells = calibration::Coverage::kCells;
  for (std::size_t i = 0; i < 2; ++i)
    for (const auto& point : view.seen[i]) {
      const auto row = static_cast<std::size_t>(
          std::clamp(static_cast<int>(point.pixel.y() * kCells / camera.height_px), 0, kCells - 1));
      const auto column = static_cast<std::size_t>(
          std::clamp(static_cast<int>(point.pixel.x() * kCells / camera.width_px), 0, kCells - 1));
      ++coverage.image[i][row][column];
    }
  ++coverage.pose[static_cast<std::size_t>(views % 3)][static_cast<std::size_t>(views % 4)];
}

}  // namespace

calibration::Board dotPlate() { return {calibration::BoardKind::kDotPlate, 9, 7, 0.03}; }

RigidTransform plateAt(double distance_m, const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& aside_m) {
  const auto points_M = calibration::boardPoints(dotPlate());
  const Eigen::Vector3d middle_M = (points_M.front() + points_M.back()) / 2;
  const double angle = turn_rad.norm();
  RigidTransform X_CM = RigidTransform::Identity();
  if (angle > 0) X_CM.linear() = Eigen::AngleAxisd(angle, turn_rad / angle).toRotationMatrix();
  X_CM.translation() = Eigen::Vector3d(0.06, 0, distance_m) + aside_m - X_CM.linear() * middle_M;
  return X_CM;
}

station::StereoOutcome stereoOutcome(const camera::StereoRig& rig) {
  station::StereoOutcome outcome;
  auto& result = outcome.result;
  result.rig = rig;
  result.rms_px = 0.024;
  result.views = 18;
  result.outliers = {"view-07", "view-12"};
  result.residuals.resize(20);
  result.hold_out = calibration::HoldOut{.epipolar_px = 0.031,
                                         .reprojection_px = 0.024,
                                         .square_mean_percent = 0.012,
                                         .square_std_percent = 0.085,
                                         .depth_rms_m = 0.000071,
                                         .views = 18,
                                         .parts = 3};
  for (auto& sigma : result.lens_sigma) sigma = {.fx_px = 0.11, .fy_px = 0.11, .cx_px = 0.16, .cy_px = 0.14};
  result.bar_sigma << 2e-5, 3e-5, 1e-5, 8e-6, 7e-6, 1.6e-5;
  result.board_shape = flatBoard();
  result.trials = {{camera::LensModel::kBrownConrady, 0.024, 0.031, 0.024},
                   {camera::LensModel::kKannalaBrandt, 0.027, 0.038, 0.029}};
  outcome.against_in_force =
      calibration::RigComparison{0.021, 0.14, 0.08, 0.031, 0.187, {{{0.3, 0.06}, {0.4, 0.09}, {0.6, 0.15}}}};
  return outcome;
}

FakeCalibration::FakeCalibration(const camera::StereoRig& rig)
    : outcome(std::make_shared<station::CalibrationOutcome>(stereoOutcome(rig))), rig_(rig) {
  shown.board = dotPlate();
  shown.views_wanted = 20;
  shown.servo.at_rest = true;
  setViews({});
}

station::CalibrationAnswer FakeCalibration::request(const station::CalibrationCommand& command) {
  last_command = command;
  asked.push_back(command.action);
  if (at_once != station::CalibrationAnswer::kAccepted) return at_once;
  ++shown.answers;
  shown.last_answer = later;
  if (later == station::CalibrationAnswer::kAccepted) obey(command);
  return at_once;
}

void FakeCalibration::obey(const station::CalibrationCommand& command) {
  switch (command.action) {
    case CalibrationAction::kBegin:
      shown.phase = CalibrationPhase::kCapturing;
      shown.job = command.job;
      shown.board = command.board;
      shown.outcome = nullptr;
      return setViews({});
    case CalibrationAction::kCapture:
      return take(shown.frame->X_CM.value());
    case CalibrationAction::kSetAutomatic:
      shown.automatic = command.on;
      return;
    case CalibrationAction::kSetDriving:
      shown.driving = command.on;
      return;
    case CalibrationAction::kRemoveView: {
      auto views = *shown.views;
      removed_.push_back(views[command.view]);
      views.erase(views.begin() + static_cast<std::ptrdiff_t>(command.view));
      return setViews(std::move(views));
    }
    case CalibrationAction::kUndoRemove: {
      auto views = *shown.views;
      views.push_back(removed_.back());
      removed_.pop_back();
      return setViews(std::move(views));
    }
    case CalibrationAction::kSolve:
      shown.phase = refusal.empty() ? CalibrationPhase::kSolved : CalibrationPhase::kRefused;
      shown.refusal = refusal;
      shown.outcome = refusal.empty() ? outcome : nullptr;
      return judgeViews();
    case CalibrationAction::kAccept:
      shown.phase = CalibrationPhase::kAccepted;
      shown.record = "2026-11-22T113000Z-stereo";
      return;
    case CalibrationAction::kDiscard:
      shown.phase = CalibrationPhase::kCapturing;
      shown.outcome = nullptr;
      return;
    case CalibrationAction::kCancel:
      shown.phase = CalibrationPhase::kIdle;
      shown.outcome = nullptr;
      return setViews({});
  }
}

void FakeCalibration::stop(control::StopReason reason) noexcept {
  ++stops;
  shown.servo.stop = reason;
  shown.servo.category = control::categoryOf(reason);
  shown.servo.reset = control::ResetRefusal::kNone;
  shown.driving = false;
}

void FakeCalibration::resetStop() noexcept {
  ++resets;
  shown.servo.stop = control::StopReason::kNone;
  shown.servo.category = control::StopCategory::kNone;
  shown.servo.reset = control::ResetRefusal::kNotStopped;
}

void FakeCalibration::setEnabling(control::EnablingPosition position) noexcept {
  shown.servo.enabling = position;
}

void FakeCalibration::see(const RigidTransform& X_CM, calibration::CaptureVerdict verdict) {
  auto frame = std::make_shared<station::BoardFrame>();
  std::tie(frame->frame.left, frame->view.seen[0]) = look(rig_.left, shown.board, X_CM);
  std::tie(frame->frame.right, frame->view.seen[1]) = look(rig_.right, shown.board, rig_.X_RC * X_CM);
  frame->verdict = verdict;
  frame->X_CM = X_CM;
  shown.frame = std::move(frame);
}

void FakeCalibration::seeNothing() {
  auto frame = std::make_shared<station::BoardFrame>();
  const auto far_away = plateAt(-1.0);
  frame->frame.left = look(rig_.left, shown.board, far_away).first;
  frame->frame.right = look(rig_.right, shown.board, far_away).first;
  shown.frame = std::move(frame);
}

void FakeCalibration::take(const RigidTransform& X_CM) {
  see(X_CM, calibration::CaptureVerdict::kNotNew);
  auto views = *shown.views;
  station::TakenView view;
  view.view = shown.frame->view;
  view.name = "view-" + std::string(views.size() < 9 ? "0" : "") + std::to_string(views.size() + 1);
  view.X_CM = X_CM;
  addToCoverage(view.view, rig_.left.intrinsics(), static_cast<int>(views.size()), shown.coverage);
  views.push_back(std::move(view));
  setViews(std::move(views));
}

void FakeCalibration::judgeViews() {
  auto views = *shown.views;
  for (std::size_t i = 0; i < views.size(); ++i) {
    views[i].is_outlier = i == 6 || i == 11;
    views[i].residual_px = views[i].is_outlier ? 0.41 : 0.019 + 0.001 * static_cast<double>(i % 7);
  }
  shown.views = std::make_shared<const std::vector<station::TakenView>>(std::move(views));
}

void FakeCalibration::setViews(std::vector<station::TakenView> views) {
  if (views.empty()) {
    shown.coverage = {};
    removed_.clear();
  }
  shown.can_undo = !removed_.empty();
  shown.progress = static_cast<double>(views.size()) / static_cast<double>(shown.views_wanted);
  shown.views = std::make_shared<const std::vector<station::TakenView>>(std::move(views));
}

}  // namespace mirrorarm::ui::test
