#include "core/station/motion_streams.h"

namespace mirrorarm::station {
namespace {

constexpr double kKept_s = 60.0;

}  // namespace

void MotionStreams::clear() {
  robot_.clear();
  camera_.clear();
}

Seconds MotionStreams::duration() const {
  return Seconds(camera_.empty() ? 0.0 : camera_.back().time_s - camera_.front().time_s);
}

// A reading that is repeated brings nothing new.
void MotionStreams::add(Stream& stream, TimePoint time, const RigidTransform& X) {
  const double time_s = Seconds(time.time_since_epoch()).count();
  if (!stream.empty() && time_s <= stream.back().time_s) return;
  stream.push_back({time_s, X});
  while (time_s - stream.front().time_s > kKept_s) stream.pop_front();
}

}  // namespace mirrorarm::station
