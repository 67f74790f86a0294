#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mirrorarm::tracking {

/// What a frame showed of the skin that carries a target's markers, to be told and recorded.
enum class SkinEvent : std::uint8_t {
  kNone,
  kSlipped,      ///< markers have moved against the others for good: the shape was taught anew
  kMarkerLost,   ///< one has fallen off: it no longer counts
  kMarkerFound,  ///< one that had fallen off is back
  kMarkerAdded,  ///< a new one moves with the body: it counts from now on
};
inline constexpr std::size_t kSkinEventCount = 5;

/// "none", "slipped", "marker_lost", "marker_found", "marker_added".
[[nodiscard]] std::string_view id(SkinEvent event);

}  // namespace mirrorarm::tracking
