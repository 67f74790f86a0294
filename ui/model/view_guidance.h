#pragma once

#include <QStringList>

#include "core/calibration/board.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::ui {

/// What is moved to show the board in another way.
enum class Moved {
  kBoard,    ///< by hand, before cameras that stand still
  kCameras,  ///< with the robot's hand, while the board lies still
};

/// How to come from the view before the cameras to the one that is wished: at most three sentences, the
/// largest difference first; empty when it is near enough to be taken. Left, right, up and down are those of
/// the left camera's image.
[[nodiscard]] QStringList guidanceTo(const RigidTransform& X_CM_wish, const RigidTransform& X_CM_now,
                                     const calibration::Board& board, Moved moved);

}  // namespace mirrorarm::ui
