#include "ui/report/report_contents.h"

#include <algorithm>
#include <limits>
#include <span>

namespace mirrorarm::ui {
namespace {

using therapy::Sample;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kCloseUp_s = 12.0, kWorthACloseUp_s = 30.0;

bool isSeen(const Sample& sample) { return sample.status != tracking::TrackStatus::kLost; }

/// Displacements are told from the first sample of training, or the first with a target where none was
/// trained.
const Sample* startOf(std::span<const Sample> samples) {
  const auto training =
      std::ranges::find_if(samples, [](const Sample& s) { return s.training && isSeen(s); });
  if (training != samples.end()) return &*training;
  const auto seen = std::ranges::find_if(samples, isSeen);
  return seen != samples.end() ? &*seen : nullptr;
}

SessionCourses coursesOf(std::span<const Sample> samples) {
  SessionCourses courses;
  const Sample* start = startOf(samples);
  for (const auto& sample : samples) {
    const bool seen = isSeen(sample);
    courses.time_s.push_back(sample.time_s);
    courses.matched.push_back(seen ? sample.matched : 0.0);
    courses.rms_mm.push_back(sample.status == tracking::TrackStatus::kTracked ? 1e3 * sample.rms_m
                                                                              : kUnknown);
    for (int axis = 0; axis < 3; ++axis) {
      const auto shift_mm = [&](const RigidTransform& now, const RigidTransform& then) {
        return 1e3 * (now.translation() - then.translation())[axis];
      };
      const auto i = static_cast<std::size_t>(axis);
      courses.healthy_mm[i].push_back(seen ? shift_mm(sample.X_BT, start->X_BT) : kUnknown);
      courses.impaired_mm[i].push_back(start ? shift_mm(sample.X_BE, start->X_BE) : kUnknown);
    }
    const double distance_m = (sample.X_BE.translation() - sample.X_BE_goal.translation()).norm();
    courses.goal_distance_mm.push_back(sample.training && seen ? 1e3 * distance_m : kUnknown);
  }
  return courses;
}

/// The spans in which `is_in` holds from sample to sample.
template <class Predicate>
std::vector<TimeSpan> spansOf(std::span<const Sample> samples, const Predicate& is_in) {
  std::vector<TimeSpan> spans;
  bool was_in = false;
  for (const auto& sample : samples) {
    const bool in = is_in(sample);
    if (in && !was_in) spans.push_back({sample.time_s, sample.time_s});
    if (in || was_in) spans.back().to_s = sample.time_s;
    was_in = in;
  }
  return spans;
}

/// The middle of the longest piece of training.
std::optional<TimeSpan> closeUpOf(std::span<const Sample> samples) {
  const auto spans = spansOf(samples, [](const Sample& s) { return s.training; });
  const auto length = [](const TimeSpan& span) { return span.to_s - span.from_s; };
  const auto longest = std::ranges::max_element(spans, {}, length);
  if (longest == spans.end() || length(*longest) < kCloseUp_s) return std::nullopt;
  if (samples.back().time_s - samples.front().time_s < kWorthACloseUp_s) return std::nullopt;
  const double middle = 0.5 * (longest->from_s + longest->to_s);
  return TimeSpan{middle - 0.5 * kCloseUp_s, middle + 0.5 * kCloseUp_s};
}

void addSamples(std::span<const Sample> samples, ReportContents& contents) {
  contents.courses = coursesOf(samples);
  contents.rests = spansOf(samples, [](const Sample& s) { return !s.training; });
  if (samples.empty()) return;
  contents.duration_s = samples.back().time_s;
  contents.close_up = closeUpOf(samples);
}

}  // namespace

records::FromStore<ReportContents> reportContents(records::Store& store, std::int64_t session) {
  ReportContents contents;
  auto head = store.session(session);
  if (!head) return unexpected(head.error());
  auto patient = store.patient(head->patient_id);
  if (!patient) return unexpected(patient.error());
  auto events = store.events(session);
  if (!events) return unexpected(events.error());
  auto samples = store.samples(session);
  if (!samples) return unexpected(samples.error());
  contents.session = std::move(*head);
  contents.patient_code = std::move(patient->code);
  contents.impaired_side = std::move(patient->impaired_side);
  contents.events = std::move(*events);
  contents.is_cut_off = contents.session.ended_at.empty();
  if (contents.is_cut_off) contents.session.measures = therapy::measure(*samples, {}, {});
  addSamples(*samples, contents);
  return contents;
}

}  // namespace mirrorarm::ui
