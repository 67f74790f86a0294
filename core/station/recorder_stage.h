#pragma once

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/common/bounded_queue.h"
#include "core/common/latest_value.h"
#include "core/control/servo_loop.h"
#include "core/records/store.h"
#include "core/robot/motion_limits.h"
#include "core/station/snapshot.h"
#include "core/station/station_settings.h"
#include "core/therapy/movement_mapping.h"

namespace mirrorarm::station {

/// Writes sessions, samples, events and black boxes, so that no other thread ever waits for a disc. The
/// control thread hands over, step() belongs to the recorder thread.
class RecorderStage {
 public:
  /// Throws std::runtime_error where the store cannot be opened.
  RecorderStage(const StationSettings& settings, const robot::MotionLimits& limits, bool simulated);
  ~RecorderStage();

  struct Begin {
    therapy::Mapping mapping = therapy::Mapping::kFollow;
  };
  struct Event {
    double time_s = 0.0;
    std::array<char, 48> text{};  ///< null-terminated
  };
  struct BlackBox {
    std::shared_ptr<const std::vector<control::ServoState>> states;
    control::StopReason reason = control::StopReason::kNone;
  };
  struct Finish {
    std::array<char, 48> reason{};
  };

  // Control thread. A full queue is counted as lost samples and shown; it holds 40 s of frames.
  void begin(therapy::Mapping mapping) noexcept { hand(Begin{mapping}); }
  void add(const therapy::Sample& sample) noexcept { hand(sample); }
  void addEvent(double time_s, std::string_view event) noexcept;
  void add(const BlackBox& box) noexcept { hand(box); }
  void finish(std::string_view reason) noexcept;

  /// Writes what has come; a few times a second.
  void step();

  LatestValue<RecordState> for_screen;  ///< taken by the screen's thread only

 private:
  using Item = std::variant<std::monostate, Begin, therapy::Sample, Event, BlackBox, Finish>;
  void hand(const Item& item) noexcept;
  void write(const Begin& begin);
  void write(const therapy::Sample& sample);
  void write(const Event& event);
  void write(const BlackBox& box);
  void write(const Finish& finish);
  void flushSamples();
  void measureLately();
  void fail(const std::string& reason);
  [[nodiscard]] therapy::SessionMeasures measured(std::span<const therapy::Sample> samples) const;

  const StationSettings settings_;
  const robot::MotionLimits limits_;
  const bool simulated_;
  std::unique_ptr<records::Store> store_;  // recorder thread, as all below
  std::int64_t patient_ = 0;
  std::vector<therapy::Sample> samples_;  // of the session
  std::size_t flushed_ = 0;               // samples_ before it are on the disc
  std::size_t measured_at_ = 0;
  RecordState state_;
  BoundedQueue<Item, 1024> items_;
  std::atomic<std::uint64_t> refused_{0};
};

}  // namespace mirrorarm::station
