#pragma once

#include <QString>

#include "core/control/follower.h"
#include "core/control/servo_state.h"
#include "core/robot/contact.h"
#include "core/robot/motion_guard.h"
#include "core/station/command.h"
#include "core/station/snapshot.h"
#include "core/therapy/movement_mapping.h"
#include "core/therapy/session_phase.h"
#include "core/tracking/tracked_target.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::ui {

// The words that people read for the values that core names by ids. Translated; whole phrases, no full stop.

[[nodiscard]] QString words(control::StopReason reason);
[[nodiscard]] QString words(control::EnablingPosition position);
[[nodiscard]] QString words(const control::Help& help);
[[nodiscard]] QString words(control::MotionRefusal refusal);
[[nodiscard]] QString words(control::FollowOutcome outcome);
/// What of the robot is too near to what.
[[nodiscard]] QString words(const robot::Contact& contact);
[[nodiscard]] QString words(robot::GuardAction action);
[[nodiscard]] QString words(station::Answer answer);
[[nodiscard]] QString words(station::Recording recording);
[[nodiscard]] QString words(therapy::Mapping mapping);
[[nodiscard]] QString words(therapy::Phase phase);
[[nodiscard]] QString words(therapy::Action action);
[[nodiscard]] QString words(tracking::TrackStatus status);
[[nodiscard]] QString words(tracking::LostReason reason);
[[nodiscard]] QString words(tracking::SkinEvent event);
[[nodiscard]] QString words(vision::Rejection reason);
[[nodiscard]] QString words(vision::ExposureWarning warning);

/// What the operator should do about a stop, one sentence.
[[nodiscard]] QString advice(control::StopReason reason);
/// Why a stop cannot be reset now; empty when it can.
[[nodiscard]] QString whyNoReset(const control::ServoState& servo);
/// What the operator should do about the light, a phrase.
[[nodiscard]] QString advice(vision::ExposureWarning warning);

}  // namespace mirrorarm::ui
