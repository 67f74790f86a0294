#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/calibration_folder.h"
#include "core/station/calibration_settings.h"
#include "core/station/calibration_snapshot.h"
#include "core/station/known_calibrations.h"
#include "core/station/taken_views.h"

namespace mirrorarm::station {

/// What a job has gathered. A value: it goes to another thread.
struct SolveQuestion {
  CalibrationJob job = CalibrationJob::kStereo;
  calibration::Board board;
  std::optional<camera::LensModel> model;  ///< nothing: the one that does better on views kept out
  calibration::ImageSize size;
  KnownCalibrations known;
  std::shared_ptr<const TakenViews::List> views;
  std::vector<calibration::TimedPose> robot;  ///< clock job only, as is the next
  std::vector<calibration::TimedPose> camera;
};

struct SolveAnswer {
  std::shared_ptr<const CalibrationOutcome> outcome;  ///< nullptr: refused
  std::string refusal;                                ///< one line: what is wrong and the remedy
  TakenViews::List views;                             ///< those of the question, with their residuals
  std::vector<calibration::PosePair> pairs;           ///< hand-eye: what it was solved from
};

/// `progress` rises to 1.
[[nodiscard]] SolveAnswer solveCalibration(const SolveQuestion& question,
                                           const calibration::DriftLimits& limits,
                                           std::atomic<double>& progress);

/// What is to be kept of an outcome, dated `date` (ISO 8601).
[[nodiscard]] calibration::CalibrationRecord recordOf(const CalibrationOutcome& outcome,
                                                      const std::string& date);

}  // namespace mirrorarm::station
