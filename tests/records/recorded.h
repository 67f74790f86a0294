#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

#include "core/records/store.h"

namespace mirrorarm::records {

/// A folder of its own for a test, removed at its end.
struct Folder {
  Folder()
      : path(std::filesystem::temp_directory_path() / ("mirrorarm records " + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  [[nodiscard]] std::filesystem::path store() const { return path / "store.sqlite"; }
  std::filesystem::path path;
};

inline RigidTransform anyPose(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  return makeTransform(Eigen::Quaterniond(any(random), any(random), any(random), any(random)),
                       Eigen::Vector3d(any(random), any(random), any(random)));
}

/// Samples with every kind of status, in training and out of it.
inline std::vector<therapy::Sample> anySamples(int count, unsigned seed = 5) {
  std::mt19937 random(seed);
  std::vector<therapy::Sample> samples;
  for (int i = 0; i < count; ++i) {
    therapy::Sample sample;
    sample.time_s = i / 24.0;
    sample.training = i % 5 != 0;
    sample.status = static_cast<tracking::TrackStatus>(i % 3);
    sample.matched = i % 11;
    sample.rms_m = 1e-4 * i;
    sample.sigma_t_m = 1e-5 * i;
    sample.sigma_r_rad = 1e-6 * i;
    if (sample.status != tracking::TrackStatus::kLost) {
      sample.X_CT = anyPose(random);
      sample.X_BT = anyPose(random);
    }
    sample.X_BE = anyPose(random);
    if (sample.training) sample.X_BE_goal = anyPose(random);
    sample.q_rad = robot::Joints::Random(7);
    sample.v_rad_s = robot::Joints::Random(7);
    sample.a_rad_s2 = robot::Joints::Random(7);
    if (i % 4 != 0) sample.force_share = 0.01 * i;
    if (i % 7 != 0) sample.help_level = 0.02 * (i % 50);
    sample.help_adapts = i % 2 == 0;
    samples.push_back(sample);
  }
  return samples;
}

inline Session anySession(std::int64_t patient) {
  Session session;
  session.patient_id = patient;
  session.started_at = "2026-01-31T09:05:00Z";
  session.exercise = "reach";
  session.mapping = "mirror";
  session.software = "0.1.0";
  session.simulated = true;
  return session;
}

inline therapy::SessionMeasures anyMeasures() {
  therapy::SessionMeasures measures;
  measures.frames = 960;
  measures.repetitions = 10;
  measures.tracked_share = 0.987;
  measures.lag_ms = 137.25;
  measures.gain = 0.97;
  measures.joint_acceleration_ratio = 0.99;
  measures.force_share = 0.43;
  measures.help_level = 0.0;
  return measures;
}

}  // namespace mirrorarm::records
