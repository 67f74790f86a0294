#pragma once

#include <filesystem>
#include <numbers>
#include <random>
#include <string>
#include <unistd.h>

#include "core/records/store.h"

namespace mirrorarm::ui {

/// A store in a folder of its own with one session: a healthy arm that reaches 100 mm to and fro, a robot
/// that follows 140 ms later, a pause, a stop with frames lost.
struct SyntheticRecord {
  static constexpr double kSeconds = 120.0, kRate_hz = 24.0, kLag_s = 0.14;

  explicit SyntheticRecord(bool finish = true, int frames = static_cast<int>(kSeconds * kRate_hz))
      : folder(std::filesystem::temp_directory_path() / ("mirrorarm_report_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(folder);
    store = std::move(*records::Store::open(folder / "store.sqlite"));
    records::Session head;
    head.patient_id = *store->addPatient({0, "P-0042", "Secret Name", 1957, "left"});
    head.started_at = "2026-01-31T09:05:00Z";
    head.exercise = "reach";
    head.mapping = "mirror";
    head.software = "0.1.0";
    head.simulated = true;
    session = *store->beginSession(head);
    const auto recorded = samples(frames);
    (void)store->addSamples(session, recorded);
    for (const auto& [time_s, event] :
         std::initializer_list<std::pair<double, const char*>>{{0.0, "aligned"},
                                                               {5.0, "started"},
                                                               {70.0, "stop.target_lost"},
                                                               {74.0, "stop_reset"},
                                                               {80.0, "started"}})
      (void)store->addEvent(session, time_s, event);
    const robot::Joints speed = robot::Joints::Constant(7, 0.24),
                        acceleration = robot::Joints::Constant(7, 0.8);
    if (finish)
      (void)store->finishSession(session, "finished", therapy::measure(recorded, speed, acceleration));
  }
  ~SyntheticRecord() {
    store.reset();
    std::filesystem::remove_all(folder);
  }
  SyntheticRecord(const SyntheticRecord&) = delete;
  SyntheticRecord& operator=(const SyntheticRecord&) = delete;

  static Eigen::Vector3d movement(double time_s) {
    const double swing = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * std::max(0.0, time_s - 5.0) / 5.0);
    return {-0.1 * swing, 0.012 * std::sin(0.9 * time_s), 0.03 * swing * swing};
  }

  static std::vector<therapy::Sample> samples(int frames) {
    std::mt19937 random(17);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<therapy::Sample> samples;
    for (int i = 0; i < frames; ++i) {
      therapy::Sample sample;
      const double time_s = i / kRate_hz;
      const Eigen::Vector3d jitter(noise(random), noise(random), noise(random));
      sample.time_s = time_s;
      sample.training = time_s >= 5.0 && (time_s < 70.0 || time_s >= 80.0);
      const bool lost = time_s > 69.7 && time_s < 72.0;
      sample.status = lost ? tracking::TrackStatus::kLost : tracking::TrackStatus::kTracked;
      sample.matched = lost ? 0 : 10 - static_cast<int>(i % 97 < 9) * 2;
      sample.rms_m = lost ? 0.0 : 0.0002 + 0.00004 * std::abs(noise(random));
      sample.X_BE.translation() = Eigen::Vector3d(0.55, -0.2, 0.3) + movement(time_s - kLag_s);
      if (!lost) {
        sample.X_BT.translation() = Eigen::Vector3d(0.55, 0.2, 0.3) + movement(time_s) + 0.0002 * jitter;
        sample.X_BE_goal.translation() = sample.X_BT.translation() - Eigen::Vector3d(0.0, 0.4, 0.0);
      }
      sample.q_rad = robot::Joints::Constant(7, 0.3);
      sample.v_rad_s = robot::Joints::Constant(7, 0.15 * std::sin(time_s));
      sample.a_rad_s2 = robot::Joints::Constant(7, 0.6 * std::cos(time_s));
      samples.push_back(sample);
    }
    return samples;
  }

  std::filesystem::path folder;
  std::unique_ptr<records::Store> store;
  std::int64_t session = 0;
};

}  // namespace mirrorarm::ui
