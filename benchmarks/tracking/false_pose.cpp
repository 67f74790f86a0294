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

enum class Company { kStrangers, kAnotherBody };

/// Poses that were called found although the target was not there. Any thread may add.
struct FalsePoses {
  std::atomic<int> of_four{0};
  std::atomic<int> of_more{0};
};

/// A target, and frames without it: strangers alone, or another body of as many markers and strangers.
class Absence {
 public:
  Absence(Company company, FalsePoses& found) : company_(company), found_(found) {}

  void operator()(int index) {
    TrialRandom random(kSeed, company_ == Company::kStrangers ? 90000 : 91000,
                       static_cast<std::uint64_t>(index));
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
    if (company_ == Company::kStrangers) return look({}, points, random);
    const Layout other = randomLayout(kMarkers, random);
    const Placed placed{&other, randomPose(random), kMarkers};
    return look(std::span(&placed, 1), points - kMarkers, random);
  }

  Company company_;
  FalsePoses& found_;
  product::ConstellationSearch search_;
};

void falsePosesIn(Company company, int frames, FalsePoses& found) {
  forEachTrial(frames, [&] { return Absence(company, found); });
}

}  // namespace

void measureFalsePoses(Run& run) {
  const int frames = run.trials(1500000, 1000);
  FalsePoses among_strangers, beside_a_body;
  falsePosesIn(Company::kStrangers, frames, among_strangers);
  falsePosesIn(Company::kAnotherBody, frames, beside_a_body);
  const int count = among_strangers.of_more + beside_a_body.of_more;
  Row row;
  row.name = "20 to 40 points, in every second frame another body of 10 markers among them";
  row.goal = "of 5 markers and more <= 1e-06 a frame, upper 95 % limit";
  row.measured = {{"of 5 and more", 1.0 * count, ""},
                  {"upper 95 % limit a frame", poissonUpperLimit(count) / (2.0 * frames), ""},
                  {"frames", 2.0 * frames, ""}};
  row.references = {{"of 4, a frame of strangers", 1.0 * among_strangers.of_four / frames, ""},
                    {"of 4, a frame with another body", 1.0 * beside_a_body.of_four / frames, ""}};
  row.pass = poissonUpperLimit(count) / (2.0 * frames) <= kMostFalse;
  run.report.rows.push_back(row);
}

}  // namespace mirrorarm::benchmarks::tracking
