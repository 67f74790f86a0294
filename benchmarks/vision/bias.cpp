#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/vision/error_map.h"
#include "benchmarks/vision/estimators.h"
#include "benchmarks/vision/stereo_camera.h"
#include "benchmarks/vision/suite.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::benchmarks::vision {
namespace {

namespace product = mirrorarm::vision;

constexpr int kDiscsInFrame = 10;
constexpr double kGap_px = 45.0;

/// Errors at one disc of one image; empty where a method found none.
struct Sample {
  Eigen::Vector2d at_px;
  std::map<std::string, Eigen::Vector2d> errors_px;
};

std::string corrected(product::CentreMethod method) {
  return std::string(product::id(method)) + "_corrected";
}
std::string uncorrected(product::CentreMethod method) {
  return std::string(product::id(method)) + "_uncorrected";
}

/// The crop around a disc, where nothing else shines.
camera::ImageView cropAround(const camera::ImageView& image, const Eigen::Vector2i& at) {
  constexpr int kHalf = 16;  // as the margin that discs keep from the border
  const int left = std::max(0, at.x() - kHalf), top = std::max(0, at.y() - kHalf);
  const int right = std::min(image.width_px, at.x() + kHalf + 1);
  const int bottom = std::min(image.height_px, at.y() + kHalf + 1);
  return {image.row(top) + left, right - left, bottom - top, image.stride};
}

void askOthers(const camera::ImageView& image, Estimators& others, Sample& sample) {
  const Eigen::Vector2i at = sample.at_px.array().round().cast<int>();
  const camera::ImageView crop = cropAround(image, at);
  const std::ptrdiff_t offset = crop.data - image.data;
  const Eigen::Vector2d corner(static_cast<double>(offset % image.stride),
                               static_cast<double>(offset / image.stride));
  for (const auto& other : others)
    if (const auto answer = other->estimate(crop, at.cast<double>() - corner))
      sample.errors_px[other->name()] = answer->centre_px + corner - sample.at_px;
}

/// The product with one of its methods.
struct OurVision {
  OurVision(const camera::StereoRig& rig, product::CentreMethod of)
      : method(of), vision(rig, settingsOf(of), product::MatcherSettings{}) {}

  void ask(const camera::StereoFrame& frame, const std::vector<StereoDisc>& discs,
           std::vector<Sample>& samples) {
    const auto& seen = vision.observe(frame);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const auto* point = pointOf(discs[i], seen);
      if (point == nullptr) continue;
      note(point->left_px, seen.left.markers[static_cast<std::size_t>(point->left)], samples[2 * i]);
      note(point->right_px, seen.right.markers[static_cast<std::size_t>(point->right)], samples[2 * i + 1]);
    }
  }

  product::CentreMethod method;
  product::StereoVision vision;

 private:
  static product::FinderSettings settingsOf(product::CentreMethod method) {
    product::FinderSettings settings;
    settings.method = method;
    return settings;
  }
  void note(const Eigen::Vector2d& centre_px, const product::DetectedMarker& marker, Sample& sample) const {
    sample.errors_px[corrected(method)] = centre_px - sample.at_px;
    sample.errors_px[uncorrected(method)] = marker.ellipse.centre_px - sample.at_px;
  }
};

/// Shows random discs to the product and to the others, frame by frame.
class Worker {
 public:
  Worker(const camera::StereoRig& rig, const DistanceRange& range, const NoiseTable& noise)
      : rig_(rig), range_(range), camera_(rig, noise) {
    using enum product::CentreMethod;
    for (const auto method : {kMaximumLikelihood, kDualConic, kLindebergFitzgibbon})
      ours_.push_back(std::make_unique<OurVision>(rig, method));
  }

  /// Left and right samples of each disc by turns.
  [[nodiscard]] std::vector<Sample> samplesOf(int index) {
    const auto stream = static_cast<std::uint64_t>(3e5 + 1e5 * range_.least_m + 1e3 * range_.most_m);
    TrialRandom random(kSeed, stream, static_cast<std::uint64_t>(index));
    const auto discs = randomDiscs(rig_, kDiscsInFrame, range_, kGap_px, random);
    const auto frame = camera_.shoot(discs, 0.0, random);
    std::vector<Sample> samples;
    for (const StereoDisc& disc : discs) {
      askOthers(frame.left.view(), others_, samples.emplace_back(Sample{disc.left_px, {}}));
      askOthers(frame.right.view(), others_, samples.emplace_back(Sample{disc.right_px, {}}));
    }
    for (const auto& our : ours_) our->ask(frame, discs, samples);
    return samples;
  }

 private:
  const camera::StereoRig& rig_;
  DistanceRange range_;
  StereoCamera camera_;
  std::vector<std::unique_ptr<OurVision>> ours_;
  Estimators others_ = otherEstimators();
};

/// Left and right samples by turns.
std::vector<Sample> samplesAt(const camera::StereoRig& rig, const DistanceRange& range, int discs,
                              const NoiseTable& noise) {
  const int frames = (discs + kDiscsInFrame - 1) / kDiscsInFrame;
  std::vector<std::vector<Sample>> of_frame(static_cast<std::size_t>(frames));
  forEachTrial(frames, [&] {
    return [&, worker = std::make_unique<Worker>(rig, range, noise)](int index) {
      of_frame[static_cast<std::size_t>(index)] = worker->samplesOf(index);
    };
  });
  std::vector<Sample> samples;
  for (const auto& frame : of_frame) samples.insert(samples.end(), frame.begin(), frame.end());
  return samples;
}

Figure figureOf(const std::string& method, const std::vector<Sample>& samples) {
  RootMeanSquare rms;
  for (const Sample& sample : samples)
    if (const auto error = sample.errors_px.find(method); error != sample.errors_px.end())
      rms.addSquare(error->second.squaredNorm(), 2);
  const int lost = static_cast<int>(samples.size()) - rms.count() / 2;
  return {lost == 0 ? method : method + " (" + std::to_string(lost) + " lost)", rms.value(), "px"};
}

/// The default method's corrected centres are judged.
Row biasRow(const std::string& name, const std::vector<Sample>& samples) {
  constexpr double kMost_px = 0.003;
  const std::string judged = corrected(product::FinderSettings{}.method);
  std::set<std::string> methods;
  for (const Sample& sample : samples)
    for (const auto& [method, error_px] : sample.errors_px) methods.insert(method);
  methods.erase(judged);
  Row row;
  row.name = name;
  row.goal = "<= " + shortNumber(kMost_px) + " px";
  row.measured = {figureOf(judged, samples)};
  for (const auto& method : methods) row.references.push_back(figureOf(method, samples));
  row.references.push_back({"discs", 0.5 * static_cast<double>(samples.size()), ""});
  row.pass = row.measured.front().name == judged && row.measured.front().value <= kMost_px;
  return row;
}

/// One map a method, of the left image.
void drawMaps(const camera::StereoRig& rig, const std::vector<Sample>& samples,
              const std::filesystem::path& out) {
  const auto& size = rig.left.intrinsics();
  std::map<std::string, ErrorMap> maps;
  for (std::size_t i = 0; i < samples.size(); i += 2)
    for (const auto& [method, error_px] : samples[i].errors_px)
      maps.try_emplace(method, "Centre error, " + method + ", no noise", size.width_px, size.height_px)
          .first->second.add(samples[i].at_px, error_px);
  for (const auto& [method, map] : maps) map.write(out / ("error_map_" + method + ".png"));
}

}  // namespace

void measureBias(Run& run) {
  const camera::StereoRig rig = fisheyeRig();
  const NoiseTable noise;
  const auto all = samplesAt(rig, {0.3, 0.6}, run.trials(600, 20), noise);
  run.report.rows.push_back(biasRow("300-600 mm, tilt up to 60 degrees, whole field", all));
  drawMaps(rig, all, run.options.out);
  for (const double distance_m : {0.3, 0.4, 0.6})
    run.report.rows.push_back(biasRow("at " + shortNumber(1000.0 * distance_m) + " mm",
                                      samplesAt(rig, {distance_m, distance_m}, run.trials(300, 10), noise)));
}

}  // namespace mirrorarm::benchmarks::vision
