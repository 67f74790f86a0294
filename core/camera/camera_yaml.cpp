#include "core/camera/camera_yaml.h"

#include <algorithm>

namespace mirrorarm::camera {
namespace {

constexpr double kLargestSide_px = 65535;

double positive(const YamlNode& node) {
  const double value = node.number();
  if (value <= 0.0) node.refuse("is not positive");
  return value;
}

int side(const YamlNode& node) {
  const auto value = node.integer();
  if (value < 1 || value > kLargestSide_px) node.refuse("is not a number of pixels");
  return static_cast<int>(value);
}

LensModel readModel(const YamlNode& node) {
  const auto model = lensModelOf(node.text());
  if (!model) node.refuse("is neither brown_conrady nor kannala_brandt");
  return *model;
}

std::array<double, 5> readDistortion(const YamlNode& node, LensModel model) {
  const auto numbers = node.numbers();
  const auto count = numbers.size();
  if (model == LensModel::kBrownConrady && count != 2 && count != 4 && count != 5)
    node.refuse("does not hold k1 k2 [p1 p2 [k3]]");
  if (model == LensModel::kKannalaBrandt && count != 4) node.refuse("does not hold k1 k2 k3 k4");
  std::array<double, 5> distortion{};
  std::copy(numbers.begin(), numbers.end(), distortion.begin());
  return distortion;
}

std::size_t usedTerms(const Intrinsics& i) {
  if (i.model == LensModel::kKannalaBrandt) return 4;
  if (i.distortion[4] != 0.0) return 5;
  return i.distortion[2] != 0.0 || i.distortion[3] != 0.0 ? 4 : 2;
}

}  // namespace

ImageSize readImageSize(const YamlNode& node) {
  if (node.size() != 2) node.refuse("does not hold width and height");
  return {side(node[0]), side(node[1])};
}

Intrinsics readIntrinsics(const YamlNode& node, const ImageSize& size) {
  Intrinsics i;
  i.model = readModel(node["model"]);
  i.width_px = size.width_px;
  i.height_px = size.height_px;
  i.fx_px = positive(node["fx_px"]);
  i.fy_px = positive(node["fy_px"]);
  i.cx_px = node["cx_px"].number();
  i.cy_px = node["cy_px"].number();
  i.distortion = readDistortion(node["distortion"], i.model);
  return i;
}

void writeIntrinsics(std::ostream& out, const Intrinsics& i, std::string_view indent) {
  out << indent << "model: " << name(i.model) << '\n'
      << indent << "fx_px: " << i.fx_px << '\n'
      << indent << "fy_px: " << i.fy_px << '\n'
      << indent << "cx_px: " << i.cx_px << '\n'
      << indent << "cy_px: " << i.cy_px << '\n'
      << indent << "distortion: ";
  for (std::size_t term = 0; term < usedTerms(i); ++term)
    out << (term == 0 ? "[" : ", ") << i.distortion[term];
  out << "]\n";
}

}  // namespace mirrorarm::camera
