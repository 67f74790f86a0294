#include "core/devices/igtl_poses.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "core/devices/big_endian.h"

namespace mirrorarm::devices {
namespace {

using Bytes = std::span<const std::byte>;

constexpr double kMetre_mm = 1e3;
constexpr double kRigidTolerance = 1e-3;  // of numbers sent with single precision
constexpr std::size_t kMatrixSize = 48;
constexpr std::size_t kQuaternionSize = 28;
constexpr std::size_t kToolSize = 70, kToolNameSize = 20, kToolMatrixAt = 22;

double floatAt(Bytes bytes, std::size_t i) { return bigEndianFloat(bytes.subspan(4 * i)); }

/// The rotation nearest to what single precision has left of it.
std::optional<RigidTransform> checked(const Eigen::Matrix3d& R, const Eigen::Vector3d& p_mm) {
  RigidTransform X = RigidTransform::Identity();
  X.linear() = R;
  X.translation() = p_mm / kMetre_mm;
  if (!isRigid(X, kRigidTolerance)) return std::nullopt;
  return makeTransform(Eigen::Quaterniond(R), X.translation());
}

/// Twelve numbers: the columns of the rotation, then the place.
std::optional<RigidTransform> matrixOf(Bytes bytes) {
  Eigen::Matrix<double, 3, 4> columns;
  for (std::size_t i = 0; i < 12; ++i)
    columns(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3)) = floatAt(bytes, i);
  return checked(columns.leftCols<3>(), columns.col(3));
}

/// Seven numbers: the place, then the quaternion x, y, z, w.
std::optional<RigidTransform> positionOf(Bytes bytes) {
  const Eigen::Quaterniond q(floatAt(bytes, 6), floatAt(bytes, 3), floatAt(bytes, 4), floatAt(bytes, 5));
  if (!(std::abs(q.norm() - 1.0) < kRigidTolerance)) return std::nullopt;
  return checked(q.normalized().toRotationMatrix(),
                 {floatAt(bytes, 0), floatAt(bytes, 1), floatAt(bytes, 2)});
}

std::string toolName(Bytes bytes) {
  std::string name;
  for (const std::byte byte : bytes.first(kToolNameSize)) {
    if (byte == std::byte{0}) break;
    name.push_back(std::to_integer<char>(byte));
  }
  return name;
}

std::vector<ReceivedPose> toolsOf(const IgtlMessage& message) {
  std::vector<ReceivedPose> poses;
  if (message.content.size() % kToolSize != 0) return poses;
  for (Bytes rest = message.content; !rest.empty(); rest = rest.subspan(kToolSize))
    if (const auto X = matrixOf(rest.subspan(kToolMatrixAt)))
      poses.push_back({toolName(rest), message.time_s, *X});
  return poses;
}

void appendFloat(std::vector<std::byte>& bytes, double value) {
  appendBigEndian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}  // namespace

std::vector<ReceivedPose> posesOf(const IgtlMessage& message) {
  if (message.type == "TDATA") return toolsOf(message);
  std::optional<RigidTransform> X;
  if (message.type == "TRANSFORM" && message.content.size() == kMatrixSize) X = matrixOf(message.content);
  if ((message.type == "POSITION" || message.type == "QTRANS") && message.content.size() == kQuaternionSize)
    X = positionOf(message.content);
  if (!X) return {};
  return {{message.device, message.time_s, *X}};
}

IgtlMessage transformMessage(const ReceivedPose& pose) {
  IgtlMessage message{"TRANSFORM", pose.name, pose.time_s, {}};
  for (Eigen::Index column = 0; column < 4; ++column)
    for (Eigen::Index row = 0; row < 3; ++row)
      appendFloat(message.content, (column == 3 ? kMetre_mm : 1.0) * pose.X(row, column));
  return message;
}

}  // namespace mirrorarm::devices
