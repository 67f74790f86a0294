#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/common/csv.h"

namespace mirrorarm::tracking::test {

/// Ten markers on the skin of a real forearm in pyomeca-upper-limb/markers.trc: 93 frames at 100 Hz, the
/// person's 51 markers by name [m].
class RealForearm {
 public:
  using Markers = std::map<std::string, Eigen::Vector3d>;
  static constexpr double kFrame_s = 0.01;

  /// Holds no frame when the file is absent.
  explicit RealForearm(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::vector<std::string> names;
    for (int number = 1; std::getline(in, line); ++number) {
      const auto cells = splitCells(line, ',');
      if (number == 4) names = cells;
      if (number >= 6 && cells.size() >= 5 && !cells[0].empty()) frames_.push_back(markersOf(cells, names));
    }
  }

  struct Frame {
    std::vector<Eigen::Vector3d> points_C;
    std::vector<std::string> names;  ///< what each point is, for the test alone
  };
  /// The points of a frame in a random order, with or without the rest of the body.
  [[nodiscard]] Frame shuffled(std::size_t index, bool whole_body, std::mt19937& rng) const {
    std::vector<std::pair<std::string, Eigen::Vector3d>> chosen;
    for (const auto& marker : frames_[index])
      if (whole_body || isOfForearm(marker.first)) chosen.push_back(marker);
    std::shuffle(chosen.begin(), chosen.end(), rng);
    Frame frame;
    for (const auto& [name, p] : chosen) {
      frame.names.push_back(name);
      frame.points_C.push_back(p);
    }
    return frame;
  }
  [[nodiscard]] std::size_t frames() const { return frames_.size(); }

  static bool isOfForearm(const std::string& name) {
    static const std::vector<std::string> kForearm{"EPICl",    "EPICm", "LARMm",    "LARMl", "LARM_elb",
                                                   "LARM_ant", "STYLr", "STYLr_up", "STYLu", "WRIST"};
    return std::find(kForearm.begin(), kForearm.end(), name) != kForearm.end();
  }

 private:
  static Markers markersOf(const std::vector<std::string>& cells, const std::vector<std::string>& names) {
    Markers markers;
    for (std::size_t c = 2; c + 2 < cells.size(); c += 3) {
      Eigen::Vector3d p_mm;
      if (parseNumber(cells[c], p_mm[0]) && parseNumber(cells[c + 1], p_mm[1]) &&
          parseNumber(cells[c + 2], p_mm[2]))
        markers[names[c]] = 0.001 * p_mm;
    }
    return markers;
  }

  std::vector<Markers> frames_;
};

/// Counts whether each marker of a target stays the same physical one, told by the first frame it was seen.
class IdentityCheck {
 public:
  /// `point_of_marker`, -1 for none; true when all `markers` were found and each is its own.
  template <class Points>
  bool add(const Points& point_of_marker, std::size_t markers, const std::vector<std::string>& names) {
    bool right = true;
    for (std::size_t i = 0; i < markers; ++i) {
      if (point_of_marker[i] < 0) {
        right = false;
        continue;
      }
      const std::string& name = names[static_cast<std::size_t>(point_of_marker[i])];
      right =
          right && RealForearm::isOfForearm(name) && name_of_marker_.emplace(i, name).first->second == name;
    }
    return right;
  }
  [[nodiscard]] std::size_t different() const {
    std::vector<std::string> names;
    for (const auto& each : name_of_marker_) names.push_back(each.second);
    std::sort(names.begin(), names.end());
    return static_cast<std::size_t>(std::unique(names.begin(), names.end()) - names.begin());
  }

 private:
  std::map<std::size_t, std::string> name_of_marker_;
};

}  // namespace mirrorarm::tracking::test
