#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::benchmarks::vision {

/// Errors over the field of view of one image: an arrow at each place, colour by length on one scale for all
/// maps, length on a scale of the map's own that a bar tells. The first 300 are drawn, the title counts all.
class ErrorMap {
 public:
  ErrorMap(std::string title, int width_px, int height_px)
      : title_(std::move(title)), width_px_(width_px), height_px_(height_px) {}

  void add(const Eigen::Vector2d& at_px, const Eigen::Vector2d& error_px) {
    errors_.push_back({at_px, error_px});
  }
  /// Throws std::runtime_error when the picture cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  struct Error {
    Eigen::Vector2d at_px;
    Eigen::Vector2d error_px;
  };

  std::string title_;
  int width_px_;
  int height_px_;
  std::vector<Error> errors_;
};

}  // namespace mirrorarm::benchmarks::vision
