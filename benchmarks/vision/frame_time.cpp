#include <algorithm>
#include <functional>
#include <sched.h>
#include <stdexcept>
#include <thread>

#include "benchmarks/timing.h"
#include "benchmarks/vision/moving_scene.h"
#include "benchmarks/vision/reference_chain.h"
#include "benchmarks/vision/stereo_discs.h"
#include "benchmarks/vision/suite.h"
#include "core/vision/stereo_vision.h"
#include "tests/common/no_heap.h"

namespace mirrorarm::benchmarks::vision {
namespace {

namespace product = mirrorarm::vision;

constexpr int kRing = 40;  // frames of 2.5 MB: no cache holds them all, as in life
constexpr int kWarmUp = 3 * kRing;
constexpr double kLookAhead_m = 0.01;

/// Calls `work` for each frame of the ring by turns.
template <class Work>
Timing timedOver(const std::vector<MovingFrame>& ring, int frames, Work work) {
  return timed(frames, [&](int i) { work(ring[static_cast<std::size_t>(i) % ring.size()]); });
}

enum class Search { kWholeImage, kRegions };

/// What observing a ring of frames costs and yields.
struct Observing {
  Timing timing;
  double heap_calls_per_frame = 0.0;
  double points_per_frame = 0.0;
};

/// Made in the thread that calls it, so that the vision's own thread inherits the cores it may run on.
Observing observe(const camera::StereoRig& rig, const std::vector<MovingFrame>& ring, int frames,
                  Search search) {
  product::StereoVision vision(rig, {}, {});
  std::ptrdiff_t points = 0;
  const auto work = [&](const MovingFrame& each) {
    if (search == Search::kRegions) vision.expect(each.discs_C, kLookAhead_m);
    points += std::ranges::count_if(vision.observe(each.frame).points, &product::StereoPoint::preferred);
  };
  (void)timedOver(ring, std::min(kWarmUp, frames), work);
  points = 0;
  Observing observing;
  observing.timing = timedOver(ring, frames, work);
  observing.points_per_frame = static_cast<double>(points) / frames;
  const auto calls = mirrorarm::testing::heapCallsOfAllThreadsIn([&] {
    for (const MovingFrame& each : ring) work(each);
  });
  observing.heap_calls_per_frame = static_cast<double>(calls) / static_cast<double>(ring.size());
  return observing;
}

/// Runs `work` in a thread that may use one core only, and so do the threads that it starts.
void onOneCore(const std::function<void()>& work) {
  bool pinned = false;
  std::thread([&] {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    CPU_SET(0, &cores);
    pinned = sched_setaffinity(0, sizeof cores, &cores) == 0;
    if (pinned) work();
  }).join();
  if (!pinned) throw std::runtime_error("cannot keep a thread on one core");
}

Row timeRow(const std::string& name, const Observing& seen, double most_median_ms, double most_p99_ms) {
  Row row;
  row.name = name;
  row.goal = "median <= " + shortNumber(most_median_ms) + " ms";
  if (most_p99_ms > 0.0) row.goal += ", p99 <= " + shortNumber(most_p99_ms) + " ms";
  row.measured = {{"median", seen.timing.median_ms, "ms"}, {"p99", seen.timing.p99_ms, "ms"}};
  row.references = {{"points a frame", seen.points_per_frame, ""}};
  row.pass =
      seen.timing.median_ms <= most_median_ms && (most_p99_ms <= 0.0 || seen.timing.p99_ms <= most_p99_ms);
  return row;
}

Row heapRow(const std::string& name, const Observing& seen) {
  Row row;
  row.name = "heap calls a frame, " + name;
  row.goal = "none";
  row.measured = {{"mean, all threads", seen.heap_calls_per_frame, ""}};
  if (mirrorarm::testing::heapIsCounted) row.pass = seen.heap_calls_per_frame == 0.0;
  return row;
}

Row ratioRow(const camera::StereoRig& rig, const std::vector<MovingFrame>& ring, int frames,
             const Observing& ours) {
  constexpr double kLeast = 25.0;
  ReferenceChain chain(rig);
  int ellipses = 0;
  const Timing timing =
      timedOver(ring, frames, [&](const MovingFrame& each) { ellipses += chain.run(each.frame); });
  const double ratio = timing.median_ms / ours.timing.median_ms;
  Row row;
  row.name =
      "remap + Canny + contours + fitEllipseDirect, same frames, two cores, against ours on the whole image";
  row.goal = ">= 25 times as long";
  row.measured = {{"ratio of medians", ratio, ""}};
  row.references = {{"median", timing.median_ms, "ms"},
                    {"p99", timing.p99_ms, "ms"},
                    {"ellipses a frame, both images", static_cast<double>(ellipses) / frames, ""}};
  row.pass = ratio >= kLeast;
  return row;
}

}  // namespace

void measureFrameTime(Run& run) {
  const camera::StereoRig rig = fisheyeRig();
  const int frames = run.trials(3000, 60);
  auto& rows = run.report.rows;
  const auto ring = movingTarget(rig, kRing);
  const Observing whole = observe(rig, ring, frames, Search::kWholeImage);
  const Observing regions = observe(rig, ring, frames, Search::kRegions);
  Observing whole_alone, regions_alone;
  onOneCore([&] {
    whole_alone = observe(rig, ring, frames, Search::kWholeImage);
    regions_alone = observe(rig, ring, frames, Search::kRegions);
  });
  rows.push_back(timeRow("10 markers, whole images, two cores", whole, 0.35, 0.7));
  rows.push_back(timeRow("10 markers, regions expected, two cores", regions, 0.35, 0.7));
  rows.push_back(timeRow("10 markers, whole images, one core", whole_alone, 0.6, 1.0));
  rows.push_back(timeRow("10 markers, regions expected, one core", regions_alone, 0.6, 1.0));
  rows.push_back(ratioRow(rig, ring, run.trials(100, 5), whole));
  const Observing crowded = observe(rig, crowdedScene(rig, kRing), run.trials(1000, 60), Search::kWholeImage);
  rows.push_back(timeRow("80 discs and 20 spurious, whole images, two cores", crowded, 2.0, 0.0));
  rows.push_back(heapRow("whole images", whole));
  rows.push_back(heapRow("regions expected", regions));
  rows.push_back(heapRow("80 discs and 20 spurious", crowded));
}

}  // namespace mirrorarm::benchmarks::vision
