#pragma once

#include <string>
#include <vector>

#include "core/devices/igtl_message.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::devices {

/// A pose that another tracker sent.
struct ReceivedPose {
  std::string name;                               ///< device of the message, or of the tool in TDATA
  double time_s = 0.0;                            ///< UTC by the sender's clock
  RigidTransform X = RigidTransform::Identity();  ///< of the tool in the tracker [m]
};

/// The poses of a message of type TRANSFORM, QTRANS, POSITION or TDATA, from millimetres to metres; none of
/// others, of a content that does not fit its type, and of a matrix that is no rotation to 1e-3.
[[nodiscard]] std::vector<ReceivedPose> posesOf(const IgtlMessage& message);

/// A TRANSFORM message.
[[nodiscard]] IgtlMessage transformMessage(const ReceivedPose& pose);

}  // namespace mirrorarm::devices
