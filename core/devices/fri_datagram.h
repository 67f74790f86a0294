#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/common/expected.h"

namespace mirrorarm::devices {

/// The datagrams of the Fast Research Interface 1.0 of the LBR 4+ (KRC2 lr), as plain values. Joints in the
/// order A1 A2 E1 A3 A4 A5 A6, zero with the arm upright; angles [rad], torques [Nm], lengths [m], times [s];
/// 3x4 poses row by row; wrenches Fx Fy Fz Tz Ty Tx, tool stiffness X Y Z RZ RY RX. The table of the wire is
/// in docs/robot-links.md; behaviour: Schreiber, Stemmer, Bischoff, ICRA 2010 workshop on innovative robot
/// control architectures.
inline constexpr std::size_t kFriJoints = 7;
inline constexpr std::size_t kFriMeasurementSize = 916;
inline constexpr std::size_t kFriCommandSize = 376;
using FriJoints = std::array<float, kFriJoints>;

enum class FriState : std::uint16_t { kOff, kMonitor, kCommand };
enum class FriQuality : std::uint16_t { kUnacceptable, kBad, kOk, kPerfect };
enum class FriControl : std::uint16_t { kOther, kPosition, kCartesianImpedance, kJointImpedance };
/// "off", "monitor", "command".
[[nodiscard]] std::string_view id(FriState state);
/// "unacceptable", "bad", "ok", "perfect".
[[nodiscard]] std::string_view id(FriQuality quality);

/// The variables that the program on the controller shares with its host: $FRI_TO_* or $FRI_FRM_*. KRL counts
/// them from 1, these arrays from 0.
struct FriVariables {
  std::array<float, 16> reals{};
  std::array<std::int32_t, 16> integers{};
  std::uint16_t booleans = 0;
  bool operator==(const FriVariables&) const = default;
};

/// What the controller counts about its host's answers, over its last 100 datagrams.
struct FriAnswerStatistics {
  float answer_rate = 0.0F;  ///< towards 1
  float latency_s = 0.0F;
  float jitter_s = 0.0F;
  float miss_rate = 0.0F;
  std::uint32_t misses = 0;
  bool operator==(const FriAnswerStatistics&) const = default;
};

/// Controller to host, once a cycle.
struct FriMeasurement {
  std::uint16_t sequence = 0;
  std::uint16_t reflected = 0;  ///< `sequence` of the host's answer that came last
  FriVariables to_host;
  float timestamp_s = 0.0F;
  FriState state = FriState::kOff;
  FriQuality quality = FriQuality::kUnacceptable;
  float measurement_period_s = 0.0F;
  float command_period_s = 0.0F;
  float safety_factor = 0.0F;  ///< what the program gave friStart
  FriAnswerStatistics answers;
  std::uint16_t drives_on = 0;  ///< a bit a drive; any bit counts as on
  FriControl control = FriControl::kOther;
  std::uint16_t drive_errors = 0;
  std::uint16_t drive_warnings = 0;
  FriJoints drive_temperatures{};
  FriJoints q_rad{};
  std::array<float, 12> flange{};
  FriJoints commanded_q_rad{};         ///< by the controller's own program
  FriJoints commanded_q_offset_rad{};  ///< what the host has added to it
  std::array<float, 12> commanded_flange{};
  std::array<float, 12> commanded_flange_offset{};
  FriJoints torque_nm{};
  FriJoints external_torque_nm{};
  std::array<float, 6> external_wrench{};
  std::array<float, 42> jacobian{};  ///< rows X Y Z RZ RY RX
  std::array<float, 49> mass_matrix{};
  FriJoints gravity_nm{};
};

/// Which fields of a command the controller is to heed. May change in the monitor state only.
enum FriFlag : std::uint32_t {
  kFriJointPosition = 0x0001,
  kFriJointTorque = 0x0004,
  kFriJointStiffness = 0x0010,
  kFriJointDamping = 0x0020,
  kFriToolPosition = 0x0100,
  kFriToolWrench = 0x0400,
  kFriToolStiffness = 0x1000,
  kFriToolDamping = 0x2000,
};

/// Host to controller: the answer to one measurement.
struct FriCommand {
  std::uint16_t sequence = 0;
  std::uint16_t reflected = 0;  ///< `sequence` of the measurement that this answers
  FriVariables from_host;
  std::uint32_t flags = 0;
  FriJoints q_rad{};
  std::array<float, 12> flange{};
  FriJoints added_torque_nm{};
  std::array<float, 6> added_wrench{};
  FriJoints joint_stiffness_nm_rad{};
  FriJoints joint_damping{};  ///< share of the critical one
  std::array<float, 6> tool_stiffness{};
  std::array<float, 6> tool_damping{};
};

/// Why bytes are no datagram.
enum class FriRefusal : std::uint8_t { kShort, kLong, kWrongId, kWrongSize, kNotFinite, kOutOfRange };
/// "short", "long", "wrong_id", "wrong_size", "not_finite", "out_of_range".
[[nodiscard]] std::string_view id(FriRefusal refusal);

/// Refuses another size, another id, angles and torques that are not finite or that no arm has, a flange that
/// is not finite, states that do not exist and periods outside 1 .. 100 ms. Does not allocate.
[[nodiscard]] Expected<FriMeasurement, FriRefusal> friMeasurementOf(
    std::span<const std::byte> bytes) noexcept;
/// Refuses another size, another id, and values that are flagged and not finite. Does not allocate.
[[nodiscard]] Expected<FriCommand, FriRefusal> friCommandOf(std::span<const std::byte> bytes) noexcept;

/// Whatever the values: a test may send wrong ones.
void encode(const FriMeasurement& measurement, std::span<std::byte, kFriMeasurementSize> bytes) noexcept;
void encode(const FriCommand& command, std::span<std::byte, kFriCommandSize> bytes) noexcept;

}  // namespace mirrorarm::devices
