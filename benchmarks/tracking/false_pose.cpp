#include <array>
#include <atomic>
#include <cstdint>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/tracking/marker_world.h"
#include "benchmarks/tracking/suite.h"
#include "core/tracking/constellation_search.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;
namespace product = mirrorarm::tracking;

constexpr double kMostFalse = 1e-6;
constexpr int kMarkers = 10;

/// Poses that were called found although the target was not there. Any thread may add.
struct FalsePoses {
  std::atomic<int> of_four{0};
  std::atomic<int> of_more{0};
};

/// A target, and frames without it: strangers alone, or another body of as many markers and strangers.
class Absence {
 public:
  Absence(bool has_body, FalsePoses& found) : has_body_(has_body), found_(found) {}

  void operator()(int index) {
    TrialRandom random(kSeed, has_body_ ? 91000 : 90000, static_cast<std::uint64_t>(index));
    const Layout target = randomLayout(kMarkers, random);
    search_.setTargets(std::array{std::span<const Vector3d>(target)});
    const MarkerScene scene = sceneWithout(random);
    const auto& result = search_.run(scene.cloud)[0];
    if (result.verdict != product::SearchVerdict::kFound) return;
    ++(result.best.matched > 4 ? found_.of_more : found_.of_four);
  }

 private:
  [[nodiscard]] MarkerScene sceneWithout(TrialRandom& random) const {
    const int points = 20 + random.index(21);
    if (!has_body_) return look({}, points, random);
    const Layout other = randomLayout(kMarkers, random);
    const Placed placed{&other, randomPose(random), kMarkers};
    return look(std::span(&placed, 1), points - kMarkers, random);
  }

  bool has_body_;
  FalsePoses& found_;
  product::ConstellationSearch search_;
};

Row falsePoseRow(const std::string& name, bool has_body, int frames) {
  FalsePoses found;
  forEachTrial(frames, [&] { return Absence(has_body, found); });
  const double limit = poissonUpperLimit(found.of_more) / frames;
  Row row;
  row.name = name;
  row.goal = "of 5 markers and more <= 1e-06 a frame, upper 95 % limit";
  row.measured = {{"of 5 and more", 1.0 * found.of_more, ""},
                  {"upper 95 % limit a frame", limit, ""},
                  {"of 4, a frame", 1.0 * found.of_four / frames, ""},
                  {"frames", 1.0 * frames, ""}};
  row.pass = limit <= kMostFalse;
  return row;
}

}  // namespace

void measureFalsePoses(Run& run) {
  run.report.rows.push_back(
      falsePoseRow("20 to 40 spurious points, no body", false, run.trials(3000000, 2000)));
  run.report.rows.push_back(
      falsePoseRow("another body of 10 markers, 10 to 30 spurious points", true, run.trials(3000000, 2000)));
}

}  // namespace mirrorarm::benchmarks::tracking
