#include "core/station/calibration_solver.h"

#include <numbers>

#include "core/calibration/board_hand_eye.h"
#include "core/calibration/board_pose.h"

namespace mirrorarm::station {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

SolveAnswer refused(const SolveQuestion& question, std::string_view reason) {
  return {nullptr, std::string(reason), *question.views, {}};
}

SolveAnswer solved(CalibrationOutcome outcome, TakenViews::List views) {
  return {std::make_shared<const CalibrationOutcome>(std::move(outcome)), {}, std::move(views), {}};
}

SolveAnswer solveStereo(const SolveQuestion& question, std::atomic<double>& progress) {
  const auto views = boardViewsOf(*question.views);
  auto result = calibration::calibrateStereo(question.board, views, question.size, question.model);
  if (!result) return refused(question, calibration::reason(result.error()));
  progress = 0.9;
  auto list = *question.views;
  for (std::size_t i = 0; i < list.size() && i < result->residuals.size(); ++i) {
    list[i].residual_px = result->residuals[i].rms_px;
    list[i].is_outlier = result->residuals[i].is_outlier;
  }
  StereoOutcome outcome{std::move(*result), std::nullopt};
  if (question.known.rig_in_force)
    outcome.against_in_force =
        calibration::compareRigs(outcome.result.rig, *question.known.rig, question.board, views);
  return solved(std::move(outcome), std::move(list));
}

/// The stations where flange and board are known, and which views they are.
struct Stations {
  std::vector<calibration::HandEyeStation> given;
  std::vector<calibration::PosePair> pairs;
  std::vector<std::size_t> views;
};

Stations stationsOf(const SolveQuestion& question) {
  Stations stations;
  for (std::size_t i = 0; i < question.views->size(); ++i) {
    const auto& taken = (*question.views)[i];
    const auto pose = calibration::poseBoard(*question.known.rig, question.board, taken.view);
    if (!pose || !taken.X_BF) continue;
    stations.given.push_back({taken.view, *taken.X_BF});
    stations.pairs.push_back({*taken.X_BF, pose->X_CM});
    stations.views.push_back(i);
  }
  return stations;
}

SolveAnswer solveHandEye(const SolveQuestion& question) {
  auto stations = stationsOf(question);
  auto refined = calibration::refineHandEye(*question.known.rig, question.board, stations.given,
                                            calibration::CameraMount::kInHand);
  if (!refined) return refused(question, calibration::reason(refined.error()));
  HandEyeOutcome outcome{std::move(refined->hand_eye), std::nullopt, std::nullopt};
  auto list = *question.views;
  for (std::size_t i = 0; i < stations.views.size(); ++i) {
    auto& taken = list[stations.views[i]];
    taken.residual_px = refined->stations_px[i];
    taken.residual_m = outcome.result.stations[i].position_m;
    taken.is_outlier = outcome.result.stations[i].is_outlier;
  }
  if (question.known.hand_eye_in_force) {
    const auto& X_FC = question.known.X_FC;
    outcome.shift_mm = 1e3 * (outcome.result.X_PC.translation() - X_FC.translation()).norm();
    outcome.turn_deg = kDegrees * angleBetween(outcome.result.X_PC, X_FC);
  }
  auto answer = solved(std::move(outcome), std::move(list));
  answer.pairs = std::move(stations.pairs);
  return answer;
}

SolveAnswer solveClock(const SolveQuestion& question) {
  auto result =
      calibration::solveClockOffset(question.robot, question.camera, calibration::CameraMount::kInHand);
  if (!result) return refused(question, calibration::reason(result.error()));
  return solved(ClockOutcome{std::move(*result)}, *question.views);
}

SolveAnswer solveDrift(const SolveQuestion& question, const calibration::DriftLimits& limits) {
  std::vector<RigidTransform> X_BF;
  for (const auto& taken : *question.views)
    if (taken.X_BF) X_BF.push_back(*taken.X_BF);
  if (X_BF.size() != question.views->size()) X_BF.clear();  // no grid without the robot
  const auto findings = calibration::checkDrift(*question.known.rig, question.known.X_FC, question.board,
                                                boardViewsOf(*question.views), X_BF, limits);
  if (!findings) return refused(question, "no view shows enough of the board: bring it before both cameras");
  return solved(DriftOutcome{*findings}, *question.views);
}

}  // namespace

SolveAnswer solveCalibration(const SolveQuestion& question, const calibration::DriftLimits& limits,
                             std::atomic<double>& progress) {
  progress = 0.0;
  const auto answer = [&]() -> SolveAnswer {
    switch (question.job) {
      case CalibrationJob::kStereo:
        return solveStereo(question, progress);
      case CalibrationJob::kHandEye:
        return solveHandEye(question);
      case CalibrationJob::kClock:
        return solveClock(question);
      case CalibrationJob::kDrift:
        return solveDrift(question, limits);
    }
    return {};
  }();
  progress = 1.0;
  return answer;
}

calibration::CalibrationRecord recordOf(const CalibrationOutcome& outcome, const std::string& date) {
  struct Keeper {
    const std::string& date;
    calibration::CalibrationRecord operator()(const StereoOutcome& stereo) const {
      auto rig = stereo.result.rig;
      rig.calibration.date = date;
      return rig;
    }
    calibration::CalibrationRecord operator()(const HandEyeOutcome& hand_eye) const {
      const auto& result = hand_eye.result;
      calibration::HandEyeNote note;
      note.date = date;
      note.method = name(result.method);
      note.pairs = static_cast<int>(result.stations.size() - result.outliers.size());
      note.rms_m = result.rms_m;
      note.rms_rad = result.rms_rad;
      note.sigma_m = result.sigma_m;
      return calibration::HandEye{calibration::CameraMount::kInHand, result.X_PC, note};
    }
    calibration::CalibrationRecord operator()(const ClockOutcome& clock) const {
      return calibration::recordOf(clock.result, date, "the robot moved before the board");
    }
    calibration::CalibrationRecord operator()(const DriftOutcome& drift) const {
      return calibration::DriftRecord{date, drift.findings};
    }
  };
  return std::visit(Keeper{date}, outcome);
}

}  // namespace mirrorarm::station
