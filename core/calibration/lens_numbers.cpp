#include "core/calibration/lens_numbers.h"

namespace mirrorarm::calibration {
namespace {

// Pixels are linear in the distortion terms, so one small step to one side is exact but for rounding, and
// small enough not to leave the lens model's range.
constexpr double kDistortionStep = 1e-6;

}  // namespace

int lensTerms(camera::LensModel model) {
  return kPinholeTerms + (model == camera::LensModel::kBrownConrady ? 2 : 4);
}

LensNumbers lensNumbers(const camera::Intrinsics& lens) {
  LensNumbers numbers(lensTerms(lens.model));
  numbers.head<kPinholeTerms>() << lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px;
  for (Eigen::Index i = kPinholeTerms; i < numbers.size(); ++i)
    numbers[i] = lens.distortion[static_cast<std::size_t>(i - kPinholeTerms)];
  return numbers;
}

camera::Intrinsics withNumbers(camera::Intrinsics lens, const LensNumbers& numbers) {
  lens.fx_px = numbers[0];
  lens.fy_px = numbers[1];
  lens.cx_px = numbers[2];
  lens.cy_px = numbers[3];
  for (Eigen::Index i = kPinholeTerms; i < numbers.size(); ++i)
    lens.distortion[static_cast<std::size_t>(i - kPinholeTerms)] = numbers[i];
  return lens;
}

SolvedLens::SolvedLens(const camera::Intrinsics& lens) : camera_(lens) {
  const auto numbers = lensNumbers(lens);
  for (Eigen::Index i = kPinholeTerms; i < numbers.size(); ++i) {
    auto stepped = numbers;
    stepped[i] += kDistortionStep;
    beside_.emplace_back(withNumbers(lens, stepped));
  }
}

std::optional<Eigen::Vector2d> SolvedLens::project(const Eigen::Vector3d& p_K,
                                                   camera::CameraModel::ProjectJacobian& by_point,
                                                   LensJacobian& by_numbers) const {
  const auto pixel = camera_.project(p_K, by_point);
  if (!pixel) return std::nullopt;
  const auto& lens = camera_.intrinsics();
  by_numbers.setZero(2, kPinholeTerms + static_cast<Eigen::Index>(beside_.size()));
  by_numbers(0, 0) = (pixel->x() - lens.cx_px) / lens.fx_px;
  by_numbers(1, 1) = (pixel->y() - lens.cy_px) / lens.fy_px;
  by_numbers(0, 2) = by_numbers(1, 3) = 1.0;
  for (std::size_t i = 0; i < beside_.size(); ++i) {
    const auto stepped = beside_[i].project(p_K);
    if (!stepped) return std::nullopt;
    by_numbers.col(kPinholeTerms + static_cast<Eigen::Index>(i)) = (*stepped - *pixel) / kDistortionStep;
  }
  return pixel;
}

}  // namespace mirrorarm::calibration
