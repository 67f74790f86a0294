#pragma once

namespace mirrorarm::ui {

/// A status that is told by shape and word, never by colour alone.
enum class Light { kOff, kGood, kWaiting, kBad };

}  // namespace mirrorarm::ui
