#include "benchmarks/statistics.h"
#include "benchmarks/vision/disc.h"
#include "benchmarks/vision/estimators.h"
#include "benchmarks/vision/suite.h"
#include "core/common/time.h"

namespace mirrorarm::benchmarks::vision {

void measureDiscTime(Run& run) {
  constexpr double kDiameter_px = 10.0, kSnr = 100.0, kLeastRatio = 0.7;
  constexpr std::uint64_t kStream = 81;
  const int count = run.trials(2000, 100);
  std::vector<camera::GreyImage> images;
  for (int i = 0; i < count; ++i) {
    TrialRandom random(kSeed, kStream, static_cast<std::uint64_t>(i));
    const Disc disc = randomDisc(kDiameter_px, kLeastRatio, random);
    images.push_back(exposed(lightOf(disc), disc.contrast / kSnr, random));
  }
  const Eigen::Vector2d middle = Eigen::Vector2d::Constant(0.5 * kDiscImage_px);
  Row row;
  row.name = "one disc, D 10 px, in an image of 80 x 80, median";
  for (const auto& estimator : allEstimators()) {
    std::vector<double> times_us;
    for (const auto& image : images) {
      const TimePoint start = Clock::now();
      const Answer answer = estimator->estimate(image.view(), middle);
      if (answer) times_us.push_back(1e6 * secondsBetween(start, Clock::now()));
    }
    (row.measured.empty() ? row.measured : row.references)
        .push_back({estimator->name(), quantile(times_us, 0.5), "us"});
  }
  run.report.rows.push_back(row);
}

}  // namespace mirrorarm::benchmarks::vision
