#pragma once

#include <cstddef>

#include "core/common/yaml.h"

namespace mirrorarm::calibration {

/// A number that cannot be negative.
[[nodiscard]] inline double atLeastZero(const YamlNode& node) {
  const double value = node.number();
  if (value < 0.0) node.refuse("is negative");
  return value;
}

/// How many.
[[nodiscard]] inline std::size_t countOf(const YamlNode& node) {
  const auto value = node.integer();
  if (value < 0) node.refuse("is negative");
  return static_cast<std::size_t>(value);
}

}  // namespace mirrorarm::calibration
