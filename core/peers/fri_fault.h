#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/common/expected.h"
#include "core/common/file_error.h"

namespace mirrorarm::peers {

/// What can go wrong on purpose. The first nine happen to datagrams on their way.
enum class FriFaultKind : std::uint8_t {
  kLost,
  kLate,  ///< by two cycles
  kDuplicated,
  kReordered,  ///< behind the next one
  kShort,
  kLong,
  kGarbled,  ///< some bytes are replaced by random ones
  kWrongId,
  kNotANumber,  ///< as the first measured, or commanded, angle
  kSilence,     ///< no datagrams either way
  kDriveError,
  kPoorQuality,  ///< the controller judges the line bad
  kStartPose,    ///< the controller holds the arm 0.1 rad from where it is
};

/// One fault and when it happens.
struct FriFault {
  FriFaultKind kind = FriFaultKind::kLost;
  bool to_answers = false;  ///< to the host's answers instead of the controller's datagrams
  double share = 1.0;       ///< of the datagrams
  double from_s = 0.0;      ///< since the controller's first cycle
  double for_s = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool isActive(double time_s) const { return time_s >= from_s && time_s < from_s + for_s; }
};

/// "[answer-]KIND[:SHARE][@FROM_S[+FOR_S]]", as in "lost:0.01", "silence@5+0.2", "answer-late:0.1@3".
/// Kinds: lost late duplicated reordered short long garbled wrong_id nan silence drive_error poor_quality
/// start_pose. The error is the reason.
[[nodiscard]] Expected<FriFault, std::string> friFaultOf(std::string_view text);

/// One fault a line; what follows a # is a remark.
[[nodiscard]] FromFile<std::vector<FriFault>> readFriFaults(const std::filesystem::path& file);

}  // namespace mirrorarm::peers
