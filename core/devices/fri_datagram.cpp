#include "core/devices/fri_datagram.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/devices/little_endian.h"

namespace mirrorarm::devices {
namespace {

constexpr std::uint16_t kMeasurementId = 0x2006;
constexpr std::uint16_t kCommandId = 0x1005;
constexpr std::size_t kIdAt = 6, kPacketSizeAt = 4;
constexpr float kMostAngle_rad = 6.3F, kMostTorque_nm = 1000.0F;
constexpr float kShortestPeriod_s = 0.0009F, kLongestPeriod_s = 0.101F;

/// A measurement as it lies on the wire: states are plain numbers until they are checked.
struct Plain {
  std::uint16_t size = 0;
  std::uint16_t id = 0;
  std::uint16_t fill = 0;
  std::uint16_t state = 0;
  std::uint16_t quality = 0;
  std::uint16_t control = 0;
};

template <class Wire, class Variables>
void visitVariables(Wire& wire, Variables& variables, Plain& plain) {
  wire(variables.reals);
  wire(variables.integers);
  wire(variables.booleans);
  wire(plain.fill);
}

template <class Wire, class Message>
void visitHead(Wire& wire, Message& message, Plain& plain) {
  wire(message.sequence);
  wire(message.reflected);
  wire(plain.size);
  wire(plain.id);
}

template <class Wire, class Measurement>
void visitInterface(Wire& wire, Measurement& m, Plain& plain) {
  wire(m.timestamp_s);
  wire(plain.state);
  wire(plain.quality);
  wire(m.measurement_period_s);
  wire(m.command_period_s);
  wire(m.safety_factor);
  wire(m.answers.answer_rate);
  wire(m.answers.latency_s);
  wire(m.answers.jitter_s);
  wire(m.answers.miss_rate);
  wire(m.answers.misses);
}

template <class Wire, class Measurement>
void visitRobot(Wire& wire, Measurement& m, Plain& plain) {
  wire(m.drives_on);
  wire(plain.control);
  wire(m.drive_errors);
  wire(m.drive_warnings);
  wire(m.drive_temperatures);
  wire(m.q_rad);
  wire(m.flange);
  wire(m.commanded_q_rad);
  wire(m.commanded_q_offset_rad);
  wire(m.commanded_flange);
  wire(m.commanded_flange_offset);
  wire(m.torque_nm);
  wire(m.external_torque_nm);
  wire(m.external_wrench);
  wire(m.jacobian);
  wire(m.mass_matrix);
  wire(m.gravity_nm);
}

/// The one list of a measurement's fields, for both directions.
template <class Wire, class Measurement>
void visitMeasurement(Wire& wire, Measurement& m, Plain& plain) {
  visitHead(wire, m, plain);
  visitVariables(wire, m.to_host, plain);
  visitInterface(wire, m, plain);
  visitRobot(wire, m, plain);
}

/// The one list of a command's fields, for both directions.
template <class Wire, class Command>
void visitCommand(Wire& wire, Command& c, Plain& plain) {
  visitHead(wire, c, plain);
  visitVariables(wire, c.from_host, plain);
  wire(c.flags);
  wire(c.q_rad);
  wire(c.flange);
  wire(c.added_torque_nm);
  wire(c.added_wrench);
  wire(c.joint_stiffness_nm_rad);
  wire(c.joint_damping);
  wire(c.tool_stiffness);
  wire(c.tool_damping);
}

std::optional<FriRefusal> refusalOf(std::span<const std::byte> bytes, std::size_t size,
                                    std::uint16_t wanted_id) {
  if (bytes.size() < size) return FriRefusal::kShort;
  if (bytes.size() > size) return FriRefusal::kLong;
  std::uint16_t number = 0;
  LittleEndianReader(bytes.subspan(kIdAt))(number);
  if (number != wanted_id) return FriRefusal::kWrongId;
  LittleEndianReader(bytes.subspan(kPacketSizeAt))(number);
  if (number != size) return FriRefusal::kWrongSize;
  return std::nullopt;
}

template <class... Arrays>
bool areFinite(const Arrays&... arrays) {
  const auto finite = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
  };
  return (finite(arrays) && ...);
}

/// No arm stands or pulls beyond these: such numbers are damaged.
bool isPossible(const FriMeasurement& m) {
  const auto within = [](const FriJoints& values, float most) {
    return std::all_of(values.begin(), values.end(), [most](float value) { return std::abs(value) <= most; });
  };
  return within(m.q_rad, kMostAngle_rad) && within(m.commanded_q_rad, kMostAngle_rad) &&
         within(m.commanded_q_offset_rad, kMostAngle_rad) && within(m.torque_nm, kMostTorque_nm) &&
         within(m.external_torque_nm, kMostTorque_nm);
}

bool isPeriod(float period_s) { return period_s >= kShortestPeriod_s && period_s <= kLongestPeriod_s; }

bool flaggedAreFinite(const FriCommand& c) {
  const auto fits = [&](FriFlag flag, const auto& values) {
    return (c.flags & flag) == 0 || areFinite(values);
  };
  return fits(kFriJointPosition, c.q_rad) && fits(kFriJointTorque, c.added_torque_nm) &&
         fits(kFriJointStiffness, c.joint_stiffness_nm_rad) && fits(kFriJointDamping, c.joint_damping) &&
         fits(kFriToolPosition, c.flange) && fits(kFriToolWrench, c.added_wrench) &&
         fits(kFriToolStiffness, c.tool_stiffness) && fits(kFriToolDamping, c.tool_damping);
}

}  // namespace

std::string_view id(FriState state) {
  constexpr std::array<std::string_view, 3> kIds{"off", "monitor", "command"};
  return kIds[static_cast<std::size_t>(state)];
}

std::string_view id(FriQuality quality) {
  constexpr std::array<std::string_view, 4> kIds{"unacceptable", "bad", "ok", "perfect"};
  return kIds[static_cast<std::size_t>(quality)];
}

std::string_view id(FriRefusal refusal) {
  constexpr std::array<std::string_view, 6> kIds{"short",      "long",       "wrong_id",
                                                 "wrong_size", "not_finite", "out_of_range"};
  return kIds[static_cast<std::size_t>(refusal)];
}

Expected<FriMeasurement, FriRefusal> friMeasurementOf(std::span<const std::byte> bytes) noexcept {
  if (const auto refusal = refusalOf(bytes, kFriMeasurementSize, kMeasurementId)) return unexpected(*refusal);
  FriMeasurement m;
  Plain plain;
  LittleEndianReader reader(bytes);
  visitMeasurement(reader, m, plain);
  if (!areFinite(m.q_rad, m.flange, m.commanded_q_rad, m.commanded_q_offset_rad, m.torque_nm,
                 m.external_torque_nm))
    return unexpected(FriRefusal::kNotFinite);
  if (plain.state > static_cast<std::uint16_t>(FriState::kCommand) ||
      plain.quality > static_cast<std::uint16_t>(FriQuality::kPerfect) ||
      plain.control > static_cast<std::uint16_t>(FriControl::kJointImpedance) ||
      !isPeriod(m.measurement_period_s) || !isPossible(m))
    return unexpected(FriRefusal::kOutOfRange);
  m.state = static_cast<FriState>(plain.state);
  m.quality = static_cast<FriQuality>(plain.quality);
  m.control = static_cast<FriControl>(plain.control);
  return m;
}

Expected<FriCommand, FriRefusal> friCommandOf(std::span<const std::byte> bytes) noexcept {
  if (const auto refusal = refusalOf(bytes, kFriCommandSize, kCommandId)) return unexpected(*refusal);
  FriCommand c;
  Plain plain;
  LittleEndianReader reader(bytes);
  visitCommand(reader, c, plain);
  if (!flaggedAreFinite(c)) return unexpected(FriRefusal::kNotFinite);
  return c;
}

void encode(const FriMeasurement& measurement, std::span<std::byte, kFriMeasurementSize> bytes) noexcept {
  Plain plain{kFriMeasurementSize,
              kMeasurementId,
              0,
              static_cast<std::uint16_t>(measurement.state),
              static_cast<std::uint16_t>(measurement.quality),
              static_cast<std::uint16_t>(measurement.control)};
  LittleEndianWriter writer(bytes);
  visitMeasurement(writer, measurement, plain);
  assert(writer.left() == 0);
}

void encode(const FriCommand& command, std::span<std::byte, kFriCommandSize> bytes) noexcept {
  Plain plain{kFriCommandSize, kCommandId, 0, 0, 0, 0};
  LittleEndianWriter writer(bytes);
  visitCommand(writer, command, plain);
  assert(writer.left() == 0);
}

}  // namespace mirrorarm::devices
