#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

std::string_view id(Rejection reason) {
  switch (reason) {
    case Rejection::kTooSmall:
      return "too_small";
    case Rejection::kTooLarge:
      return "too_large";
    case Rejection::kTooElongated:
      return "too_elongated";
    case Rejection::kNotAnEllipse:
      return "not_an_ellipse";
    case Rejection::kAtBorder:
      return "at_border";
    case Rejection::kSaturated:
      return "saturated";
    case Rejection::kCut:
      return "cut";
  }
  return "";
}

}  // namespace mirrorarm::vision
