#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/common/expected.h"
#include "core/experiments/rig_bias.h"
#include "core/experiments/trial_calibration.h"

namespace mirrorarm::experiments {

/// One standstill: the object as tracking found it, and where its middle truly was.
struct AccuracyStation {
  Eigen::Vector3d measured_B = Eigen::Vector3d::Zero();  ///< X_BF X_FC X_CT times the object's middle
  Eigen::Vector3d true_B = Eigen::Vector3d::Zero();
};

/// What a set of stations says about the whole chain, along the axes of the base.
struct AccuracyStatistics {
  Eigen::Vector3d std_mm = Eigen::Vector3d::Zero();   ///< of the error over the stations
  Eigen::Vector3d bias_mm = Eigen::Vector3d::Zero();  ///< its mean
  double rms_mm = 0.0;                                ///< of its length, bias included
};
/// At least one station.
[[nodiscard]] AccuracyStatistics statisticsOf(std::span<const AccuracyStation> stations);

/// Section 3.2: calibrated stereo, calibrated hand-eye and tracking together over the paper's cuboid.
struct AccuracyResult {
  TrialCalibration calibration;
  RigBias rig_bias;  ///< over the cuboid
  AccuracyStatistics chain;
  AccuracyStatistics given;  ///< the same images with the true rig and the true X_FC: tracking alone
  double fit_rms_mm = 0.0;   ///< mean misfit of the frames
  int frames = 0;
  int tracked = 0;
};

/// The robot carries the cameras over the cuboid of 60 x 60 x 40 mm in steps of 20 mm above a target of ten
/// markers on a table; its own poses, read with the encoders' noise, are the truth. Everything is calibrated
/// from images first. Takes about a minute. The error says what could not be read or solved.
[[nodiscard]] Expected<AccuracyResult, std::string> measureAccuracy(const std::filesystem::path& resources,
                                                                    std::uint64_t seed = 20151213);

}  // namespace mirrorarm::experiments
