#include "core/station/recorder_stage.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "core/common/calendar.h"
#include "core/common/log.h"
#include "core/station/black_box_file.h"

namespace mirrorarm::station {
namespace {

/// Samples between two looks at how the session goes, and how many of the newest such a look takes.
constexpr std::size_t kMeasureEvery = 24, kMeasureOver = 240;

std::array<char, 48> shortText(std::string_view text) {
  std::array<char, 48> copy{};
  text.copy(copy.data(), copy.size() - 1);
  return copy;
}

/// A patient known by a code alone, the next free one of the kind P-0001.
records::FromStore<std::int64_t> addPatientWithoutName(records::Store& store) {
  const auto known = store.patients();
  if (!known) return unexpected(known.error());
  for (std::size_t number = known->size() + 1;; ++number) {
    std::array<char, 24> code{};
    std::snprintf(code.data(), code.size(), "P-%04zu", number);
    const bool taken =
        std::ranges::any_of(*known, [&](const auto& patient) { return patient.code == code.data(); });
    if (!taken) return store.addPatient({0, code.data(), "", 0, ""});
  }
}

}  // namespace

RecorderStage::RecorderStage(const StationSettings& settings, const robot::MotionLimits& limits,
                             bool simulated)
    : settings_(settings), limits_(limits), simulated_(simulated), patient_(settings.patient_id) {
  if (settings.store_file.empty()) return;
  auto store = records::Store::open(settings.store_file);
  if (!store) throw std::runtime_error(store.error().reason);
  store_ = std::move(*store);
}

RecorderStage::~RecorderStage() = default;

void RecorderStage::hand(const Item& item) noexcept {
  if (!items_.push(item)) refused_.fetch_add(1, std::memory_order_relaxed);
}

void RecorderStage::addEvent(double time_s, std::string_view event) noexcept {
  hand(Event{time_s, shortText(event)});
}

void RecorderStage::finish(std::string_view reason) noexcept { hand(Finish{shortText(reason)}); }

void RecorderStage::step() {
  while (auto item = items_.pop()) {
    std::visit(
        [this](const auto& content) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(content)>, std::monostate>) write(content);
        },
        *item);
  }
  flushSamples();
  measureLately();
  state_.lost_samples = refused_.load(std::memory_order_relaxed);
  for_screen.put(state_);
}

void RecorderStage::write(const Begin& begin) {
  samples_.clear();
  flushed_ = measured_at_ = 0;
  state_ = {};
  if (!store_) return;
  if (patient_ == 0) {
    const auto made = addPatientWithoutName(*store_);
    if (!made) return fail(made.error().reason);
    patient_ = *made;
  }
  records::Session session;
  session.patient_id = patient_;
  session.started_at = isoUtcNow();
  session.exercise = settings_.exercise;
  session.mapping = id(begin.mapping);
  session.software = MIRRORARM_VERSION;
  session.simulated = simulated_;
  const auto begun = store_->beginSession(session);
  if (!begun) return fail(begun.error().reason);
  state_.session = *begun;
  state_.recording = Recording::kWriting;
}

void RecorderStage::write(const therapy::Sample& sample) { samples_.push_back(sample); }

void RecorderStage::write(const Event& event) {
  if (state_.recording != Recording::kWriting) return;
  const auto added = store_->addEvent(state_.session, event.time_s, event.text.data());
  if (!added) fail(added.error().reason);
}

void RecorderStage::write(const BlackBox& box) {
  if (settings_.black_box_folder.empty()) return;
  const auto written = writeBlackBox(blackBoxFile(settings_.black_box_folder, box.reason), *box.states);
  if (!written) log(LogLevel::kError, "records: " + written.error());
}

void RecorderStage::write(const Finish& finish) {
  flushSamples();
  state_.measures = measured(samples_);
  if (state_.recording != Recording::kWriting) return;
  const auto finished = store_->finishSession(state_.session, finish.reason.data(), state_.measures);
  if (!finished) return fail(finished.error().reason);
  state_.recording = Recording::kComplete;
}

void RecorderStage::flushSamples() {
  if (state_.recording != Recording::kWriting || flushed_ == samples_.size()) return;
  const auto added = store_->addSamples(state_.session, std::span(samples_).subspan(flushed_));
  if (!added) return fail(added.error().reason);
  flushed_ = samples_.size();
}

void RecorderStage::measureLately() {
  if (state_.recording == Recording::kComplete || samples_.size() < measured_at_ + kMeasureEvery) return;
  measured_at_ = samples_.size();
  state_.measures = measured(std::span(samples_).last(std::min(samples_.size(), kMeasureOver)));
}

void RecorderStage::fail(const std::string& reason) {
  state_.recording = Recording::kFailed;
  log(LogLevel::kError, "records: " + reason);
}

therapy::SessionMeasures RecorderStage::measured(std::span<const therapy::Sample> samples) const {
  return therapy::measure(samples, limits_.max_speed_rad_s, limits_.max_acceleration_rad_s2);
}

}  // namespace mirrorarm::station
