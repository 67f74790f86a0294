#include "core/devices/igtl_robot_protocol.h"

#include <bit>
#include <chrono>
#include <cmath>

#include "core/devices/big_endian.h"

namespace mirrorarm::devices {
namespace {

using Bytes = std::span<const std::byte>;
using robot::Joints;

constexpr std::string_view kSensor = "SENSOR", kState = "RobotState", kCommand = "RobotCommand";
constexpr std::size_t kNumbersAt = 10;  // behind their count, the sensor's status and its unit
constexpr std::size_t kMostNumbers = 6 + 3 * robot::kMaxJoints;
constexpr double kMostSequence = 4294967295.0;
constexpr double kLongestPeriod_s = 1.0;
static_assert(kIgtlHeaderSize + kNumbersAt + 8 * kMostNumbers <= kMostRobotMessage);

double calendarSeconds() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Numbers on their way onto the wire.
class Numbers {
 public:
  void add(double value) { values_[count_++] = value; }
  void add(const Joints& q) {
    for (const double value : q) add(value);
  }
  [[nodiscard]] Bytes encode(std::string_view device, RobotMessageBytes& bytes) const {
    std::array<std::byte, kNumbersAt + 8 * kMostNumbers> content{};
    content[0] = static_cast<std::byte>(count_);
    for (std::size_t i = 0; i < count_; ++i)
      putBigEndian(std::bit_cast<std::uint64_t>(values_[i]), std::span(content).subspan(kNumbersAt + 8 * i));
    return encodeIgtl(kSensor, device, calendarSeconds(), std::span(content).first(kNumbersAt + 8 * count_),
                      bytes);
  }

 private:
  std::array<double, kMostNumbers> values_{};
  std::size_t count_ = 0;
};

/// Numbers that came over the wire, taken one after another.
class Reading {
 public:
  static std::optional<Reading> of(const IgtlView& view, std::string_view device) {
    if (view.type != kSensor || view.device != device || view.content.size() < kNumbersAt)
      return std::nullopt;
    Reading reading;
    reading.count_ = std::to_integer<std::size_t>(view.content[0]);
    if (reading.count_ > kMostNumbers || view.content.size() != kNumbersAt + 8 * reading.count_)
      return std::nullopt;
    for (std::size_t i = 0; i < reading.count_; ++i) {
      reading.values_[i] =
          std::bit_cast<double>(bigEndian<std::uint64_t>(view.content.subspan(kNumbersAt + 8 * i)));
      if (!std::isfinite(reading.values_[i])) return std::nullopt;
    }
    return reading;
  }
  [[nodiscard]] std::size_t left() const { return count_ - next_; }
  double take() { return values_[next_++]; }
  Joints takeJoints(std::size_t count) {
    Joints q(static_cast<Eigen::Index>(count));
    for (double& value : q) value = take();
    return q;
  }
  /// A whole number up to `most`; nothing else.
  std::optional<std::uint32_t> takeWhole(double most) {
    const double value = take();
    if (value < 0.0 || value > most || value != std::floor(value)) return std::nullopt;
    return static_cast<std::uint32_t>(value);
  }

 private:
  std::array<double, kMostNumbers> values_{};
  std::size_t count_ = 0, next_ = 0;
};

}  // namespace

Bytes encode(const RobotStateMessage& state, RobotMessageBytes& bytes) noexcept {
  Numbers numbers;
  numbers.add(state.sequence);
  numbers.add(state.heeded);
  numbers.add(static_cast<double>(state.fault));
  numbers.add(state.takes_commands ? 1.0 : 0.0);
  numbers.add(state.period_s);
  numbers.add(static_cast<double>(state.q_rad.size()));
  numbers.add(state.q_rad);
  numbers.add(state.v_rad_s);
  numbers.add(state.external_torque_nm);
  return numbers.encode(kState, bytes);
}

Bytes encode(const RobotCommandMessage& command, RobotMessageBytes& bytes) noexcept {
  Numbers numbers;
  numbers.add(command.sequence);
  numbers.add(command.reflected);
  numbers.add(command.drive ? 1.0 : 0.0);
  numbers.add(command.q_rad);
  return numbers.encode(kCommand, bytes);
}

std::optional<RobotStateMessage> robotStateOf(const IgtlView& view) noexcept {
  auto reading = Reading::of(view, kState);
  if (!reading || reading->left() < 6) return std::nullopt;
  const auto sequence = reading->takeWhole(kMostSequence);
  const auto heeded = reading->takeWhole(kMostSequence);
  const auto fault = reading->takeWhole(static_cast<double>(robot::LinkFault::kPoorLine));
  const auto takes_commands = reading->takeWhole(1.0);
  const double period_s = reading->take();
  const auto joints = reading->takeWhole(robot::kMaxJoints);
  if (!sequence || !heeded || !fault || !takes_commands || !joints) return std::nullopt;
  const bool feels = reading->left() == 3 * std::size_t{*joints};
  if ((!feels && reading->left() != 2 * std::size_t{*joints}) || !(period_s > 0.0) ||
      period_s > kLongestPeriod_s)
    return std::nullopt;
  RobotStateMessage state{
      *sequence, *heeded, static_cast<robot::LinkFault>(*fault), *takes_commands == 1, period_s, {}, {}, {}};
  state.q_rad = reading->takeJoints(*joints);
  state.v_rad_s = reading->takeJoints(*joints);
  if (feels) state.external_torque_nm = reading->takeJoints(*joints);
  return state;
}

std::optional<RobotCommandMessage> robotCommandOf(const IgtlView& view) noexcept {
  auto reading = Reading::of(view, kCommand);
  if (!reading || reading->left() < 3) return std::nullopt;
  const auto sequence = reading->takeWhole(kMostSequence);
  const auto reflected = reading->takeWhole(kMostSequence);
  const auto drive = reading->takeWhole(1.0);
  if (!sequence || !reflected || !drive || reading->left() > robot::kMaxJoints) return std::nullopt;
  return RobotCommandMessage{*sequence, *reflected, *drive == 1, reading->takeJoints(reading->left())};
}

IgtlMessage statusMessage(std::uint16_t code, const std::string& text) {
  constexpr std::size_t kTextAt = 30;  // behind code, sub-code and the error's name
  IgtlMessage message{"STATUS", "Robot", calendarSeconds(), std::vector<std::byte>(kTextAt)};
  putBigEndian(code, message.content);
  for (const char c : text) message.content.push_back(static_cast<std::byte>(c));
  message.content.push_back(std::byte{0});
  return message;
}

}  // namespace mirrorarm::devices
