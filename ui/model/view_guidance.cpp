#include "ui/model/view_guidance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

struct Guidance {
  Q_DECLARE_TR_FUNCTIONS(Guidance)
};

// Nearer than this the view tells as much as the one that is wished.
constexpr double kNear_cm = 3.0;
constexpr double kNear_deg = 6.0;
constexpr int kMostSentences = 3;

struct Difference {
  double weight = 0.0;  ///< 1 is just worth saying
  QString sentence;
};

/// The middle between the first and the last point of the board.
Eigen::Vector3d middleOf(const calibration::Board& board) {
  const auto points = calibration::boardPoints(board);
  return points.empty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d((points.front() + points.back()) / 2);
}

QString nearer(double cm, Moved moved) {
  const int whole = static_cast<int>(std::lround(std::abs(cm)));
  if (moved == Moved::kBoard)
    return (cm < 0 ? Guidance::tr("Bring the board %1 cm nearer.")
                   : Guidance::tr("Take the board %1 cm farther away."))
        .arg(whole);
  return (cm < 0 ? Guidance::tr("Bring the cameras %1 cm nearer to the board.")
                 : Guidance::tr("Take the cameras %1 cm farther from the board."))
      .arg(whole);
}

QString aside(double cm, Moved moved) {
  const int whole = static_cast<int>(std::lround(std::abs(cm)));
  if (moved == Moved::kBoard)
    return (cm < 0 ? Guidance::tr("Move it %1 cm to the left in the image.")
                   : Guidance::tr("Move it %1 cm to the right in the image."))
        .arg(whole);
  return (cm < 0 ? Guidance::tr("Move the cameras %1 cm to the right.")
                 : Guidance::tr("Move the cameras %1 cm to the left."))
      .arg(whole);
}

QString upOrDown(double cm, Moved moved) {
  const int whole = static_cast<int>(std::lround(std::abs(cm)));
  if (moved == Moved::kBoard)
    return (cm < 0 ? Guidance::tr("Move it %1 cm up in the image.")
                   : Guidance::tr("Move it %1 cm down in the image."))
        .arg(whole);
  return (cm < 0 ? Guidance::tr("Move the cameras %1 cm down.") : Guidance::tr("Move the cameras %1 cm up."))
      .arg(whole);
}

int degrees(double deg) { return 5 * static_cast<int>(std::lround(std::abs(deg) / 5)); }

/// About the image's x axis: positive brings the lower edge away.
QString tiltUpOrDown(double deg, Moved moved) {
  if (moved == Moved::kBoard)
    return (deg > 0 ? Guidance::tr("Tilt its upper edge %1° towards the cameras.")
                    : Guidance::tr("Tilt its lower edge %1° towards the cameras."))
        .arg(degrees(deg));
  return (deg > 0 ? Guidance::tr("Swing the cameras %1° upwards around the board.")
                  : Guidance::tr("Swing the cameras %1° downwards around the board."))
      .arg(degrees(deg));
}

/// About the image's y axis: positive brings the right edge nearer.
QString tiltAside(double deg, Moved moved) {
  if (moved == Moved::kBoard)
    return (deg > 0 ? Guidance::tr("Tilt its right edge %1° towards the cameras.")
                    : Guidance::tr("Tilt its left edge %1° towards the cameras."))
        .arg(degrees(deg));
  return (deg > 0 ? Guidance::tr("Swing the cameras %1° to the right around the board.")
                  : Guidance::tr("Swing the cameras %1° to the left around the board."))
      .arg(degrees(deg));
}

/// About the line of sight: positive turns the board clockwise in the image.
QString roll(double deg, Moved moved) {
  if (moved == Moved::kBoard)
    return (deg > 0 ? Guidance::tr("Turn it %1° clockwise in the image.")
                    : Guidance::tr("Turn it %1° counter-clockwise in the image."))
        .arg(degrees(deg));
  return (deg > 0 ? Guidance::tr("Turn the cameras %1° counter-clockwise.")
                  : Guidance::tr("Turn the cameras %1° clockwise."))
      .arg(degrees(deg));
}

}  // namespace

QStringList guidanceTo(const RigidTransform& X_CM_wish, const RigidTransform& X_CM_now,
                       const calibration::Board& board, Moved moved) {
  const Eigen::Vector3d middle_M = middleOf(board);
  const Eigen::Vector3d shift_cm = 100.0 * (X_CM_wish * middle_M - X_CM_now * middle_M);
  const Eigen::Vector3d turn_deg =
      rotationVector(X_CM_wish.linear() * X_CM_now.linear().transpose()) * 180.0 / std::numbers::pi;
  std::vector<Difference> differences{
      {std::abs(shift_cm.z()) / kNear_cm, nearer(shift_cm.z(), moved)},
      {std::abs(shift_cm.x()) / kNear_cm, aside(shift_cm.x(), moved)},
      {std::abs(shift_cm.y()) / kNear_cm, upOrDown(shift_cm.y(), moved)},
      {std::abs(turn_deg.x()) / kNear_deg, tiltUpOrDown(turn_deg.x(), moved)},
      {std::abs(turn_deg.y()) / kNear_deg, tiltAside(turn_deg.y(), moved)},
      {std::abs(turn_deg.z()) / kNear_deg, roll(turn_deg.z(), moved)},
  };
  std::ranges::stable_sort(differences, std::greater{}, &Difference::weight);
  QStringList sentences;
  for (const auto& difference : differences)
    if (difference.weight > 1.0 && sentences.size() < kMostSentences) sentences << difference.sentence;
  return sentences;
}

}  // namespace mirrorarm::ui
