#include "core/calibration/calibration_refusal.h"

#include <string_view>

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kMostNamed = 8;

std::string_view text(CalibrationError error) {
  switch (error) {
    case CalibrationError::kTooFewViews:
      return "too few usable views of the board: 3 to solve from and 1 to keep out are the least, 20 are "
             "better";
    case CalibrationError::kNotSolved:
      return "no lens fits the views: check the board's size and the model";
    case CalibrationError::kMisfit:
      return "the views contradict each other: check the board's size, that it is flat and stood still";
    case CalibrationError::kViewsTooAlike:
      return "the views do not fix the focal length: tilt the board by 20 to 45 degrees in all directions";
    case CalibrationError::kImageSize:
      return "the lens looks far past the middle of the image: give whole images, in the size that the "
             "camera "
             "takes them";
    case CalibrationError::kSidesSwapped:
      return "left and right are swapped: the right camera stands to the left of the left one; swap the two "
             "folders or the two cameras";
    case CalibrationError::kPairsOutOfOrder:
      return "left and right images are paired wrongly: name partners by the same number";
  }
  return "is refused";
}

}  // namespace

std::string reason(const CalibrationRefusal& refusal) {
  std::string line(text(refusal.error));
  for (std::size_t i = 0; i < refusal.views.size() && i < kMostNamed; ++i)
    line += (i == 0 ? ": " : ", ") + refusal.views[i];
  if (refusal.views.size() > kMostNamed)
    line += " and " + std::to_string(refusal.views.size() - kMostNamed) + " more";
  return line;
}

}  // namespace mirrorarm::calibration
