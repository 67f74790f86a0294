#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/tracking/target.h"

namespace mirrorarm::tracking {

/// What is wrong with the places of a target's markers.
enum class LayoutIssue : std::uint8_t {
  kCollinear,        ///< on one line: no turn about it can be measured; such a target is refused
  kNearlyCollinear,  ///< near one line: the turn about it is uncertain
  kSymmetric,        ///< all markers lie on each other in another pose too
  kPlanarAmbiguous,  ///< likewise, and flat: turned over it looks the same
  kAlikeInPart,  ///< so many of the markers lie on each other in another pose that half of them may not do
  kTooNear,      ///< two markers so near that their images merge or that they are mixed up
  kPoorTurn,     ///< too small a spread for a sure turn
};
/// "collinear", "nearly_collinear", "symmetric", "planar_ambiguous", "alike_in_part", "too_near",
/// "poor_turn".
[[nodiscard]] std::string_view id(LayoutIssue issue);

/// How well a target's layout suits tracking.
struct LayoutReport {
  std::string target;  ///< its name
  int markers = 0;
  double length_m = 0.0;     ///< spread along the longest direction, root mean square
  double width_m = 0.0;      ///< beside the line that fits best, root mean square
  double thickness_m = 0.0;  ///< beside the plane that fits best, root mean square
  double smallest_distance_m = 0.0;
  double turn_sigma_rad = 0.0;  ///< expected of its worst axis, facing the cameras at 0.4 m, all markers seen
  /// Misfit of all markers laid on each other in another pose, root mean square; infinite when there is no
  /// such pose or it is far worse than what a tracker accepts.
  double symmetric_rms_m = 0.0;
  int alike_markers = 0;  ///< most markers that lie on others in another pose, closer than a tracker can tell
  int needed_markers = 0;  ///< that must be seen for a unique answer, whichever they are
  std::vector<LayoutIssue> issues;

  [[nodiscard]] bool has(LayoutIssue issue) const;
};

/// Checks one target of at least 3 markers. Some milliseconds.
[[nodiscard]] LayoutReport checkLayout(const Target& target);

/// Two targets of which one may be taken for the other.
struct LookAlike {
  std::string a, b;        ///< their names
  int shared_markers = 0;  ///< that lie alike in both
  int needed_markers = 0;  ///< of either must be seen to tell them apart; 0: no number tells
};

/// Pairs of targets that share so many markers' places that seeing just these would be accepted for either.
[[nodiscard]] std::vector<LookAlike> findLookAlikes(std::span<const Target> targets);

/// One line for engineers, "<id>: <target> ..."; with the figures.
[[nodiscard]] std::string describe(const LayoutReport& report, LayoutIssue issue);
[[nodiscard]] std::string describe(const LookAlike& pair);
/// All of them, target by target and then pair by pair.
[[nodiscard]] std::vector<std::string> layoutWarnings(std::span<const Target> targets);

}  // namespace mirrorarm::tracking
