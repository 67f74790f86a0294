#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/records/store.h"

namespace mirrorarm::ui {

/// From one time of a session to another [s].
struct TimeSpan {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// The session as courses over its time, one entry a camera frame; what was not known then is NaN.
struct SessionCourses {
  std::vector<double> time_s;
  std::array<std::vector<double>, 3> healthy_mm;   ///< target, from where training began, robot base x, y, z
  std::array<std::vector<double>, 3> impaired_mm;  ///< end effector, from where it was then
  std::vector<double> goal_distance_mm;            ///< end effector to where it belonged, in training
  std::vector<double> matched;                     ///< markers found
  std::vector<double> rms_mm;                      ///< misfit of the target
};

/// All that a session's report says, computed from the store; words and drawing come later.
struct ReportContents {
  records::Session session;  ///< the measures of a session that was cut off are computed here, without ratios
  std::string patient_code;
  std::string impaired_side;
  bool is_cut_off = false;  ///< never finished
  double duration_s = 0.0;  ///< to the last sample
  SessionCourses courses;
  std::vector<TimeSpan> rests;  ///< where the robot did not follow
  std::optional<TimeSpan>
      close_up;  ///< some seconds of training worth a closer look; nothing in short sessions
  std::vector<records::Store::Event> events;
};

/// Reads `session` and computes its report. Any thread that may use the store.
[[nodiscard]] records::FromStore<ReportContents> reportContents(records::Store& store, std::int64_t session);

}  // namespace mirrorarm::ui
