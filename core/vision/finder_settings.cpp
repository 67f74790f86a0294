#include "core/vision/finder_settings.h"

#include <array>

namespace mirrorarm::vision {

std::string_view id(CentreMethod method) {
  switch (method) {
    case CentreMethod::kMaximumLikelihood:
      return "maximum_likelihood";
    case CentreMethod::kDualConic:
      return "dual_conic";
    case CentreMethod::kLindebergFitzgibbon:
      return "lindeberg_fitzgibbon";
  }
  return "";
}

std::optional<CentreMethod> centreMethodOf(std::string_view text) {
  for (const auto method :
       {CentreMethod::kMaximumLikelihood, CentreMethod::kDualConic, CentreMethod::kLindebergFitzgibbon})
    if (text == id(method)) return method;
  return std::nullopt;
}

}  // namespace mirrorarm::vision
