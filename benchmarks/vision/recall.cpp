#include <algorithm>
#include <fstream>
#include <map>
#include <mutex>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/vision/spurious_scene.h"
#include "benchmarks/vision/suite.h"
#include "core/camera/image_file.h"
#include "core/vision/marker_finder.h"

namespace mirrorarm::benchmarks::vision {
namespace {

namespace product = mirrorarm::vision;

constexpr double kSame_px = 1.0;
constexpr std::size_t kMostPictures = 20;

/// What one frame went wrong in, a line each.
using Faults = std::vector<std::string>;

/// Counts over all frames; guarded by its own lock.
class Tally {
 public:
  explicit Tally(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::remove_all(folder_);
  }

  void take(std::uint64_t index, const SpuriousFrame& frame, const product::Detection& found) {
    Faults faults;
    int discs = 0, lost = 0, made_up = 0;
    for (const PlacedLight& light : frame.lights)
      if (light.shape == Shape::kDisc) {
        ++discs;
        lost += isFound(light, found) ? 0 : (faults.push_back(lostLine(light, found)), 1);
      }
    for (std::size_t i = 0; i < found.markers.size(); ++i)
      if (!isTrue(i, frame, found)) {
        ++made_up;
        faults.push_back(falseLine(found.markers[i], frame));
      }
    const std::scoped_lock lock(guard_);
    discs_ += discs;
    lost_ += lost;
    false_ += made_up;
    if (!faults.empty() && pictures_.size() < kMostPictures) pictures_[index] = {frame.image, faults};
  }

  [[nodiscard]] int discs() const { return discs_; }
  [[nodiscard]] int lost() const { return lost_; }
  [[nodiscard]] int falseDiscs() const { return false_; }

  /// Failing frames with a line of why, for those who mend it.
  void savePictures() const {
    if (pictures_.empty()) return;
    std::filesystem::create_directories(folder_);
    std::ofstream why(folder_ / "failures.txt");
    for (const auto& [index, picture] : pictures_) {
      const std::string name = "frame_" + std::to_string(index) + ".png";
      if (const auto written = camera::writeImage(folder_ / name, picture.image); !written)
        throw std::runtime_error(written.error());
      for (const auto& fault : picture.faults) why << name << ": " << fault << "\n";
    }
  }

 private:
  struct Picture {
    camera::GreyImage image;
    Faults faults;
  };

  static const product::DetectedMarker* nearest(const Eigen::Vector2d& at, const product::Detection& found) {
    const auto distance = [&](const product::DetectedMarker& marker) {
      return (marker.centre_px - at).norm();
    };
    const auto marker = std::ranges::min_element(found.markers, {}, distance);
    return marker == found.markers.end() ? nullptr : &*marker;
  }
  static bool isFound(const PlacedLight& disc, const product::Detection& found) {
    const auto* marker = nearest(disc.centre_px, found);
    return marker != nullptr && (marker->centre_px - disc.centre_px).norm() <= kSame_px;
  }
  /// A marker on a disc, and the nearest one to it: a second one on the same disc is false.
  static bool isTrue(std::size_t index, const SpuriousFrame& frame, const product::Detection& found) {
    const auto& marker = found.markers[index];
    return std::ranges::any_of(frame.lights, [&](const PlacedLight& light) {
      return light.shape == Shape::kDisc && (marker.centre_px - light.centre_px).norm() <= kSame_px &&
             nearest(light.centre_px, found) == &marker;
    });
  }
  static std::string describe(const PlacedLight& light) {
    return std::string(id(light.shape)) + " at " + shortNumber(light.centre_px.x()) + " " +
           shortNumber(light.centre_px.y()) + ", " + shortNumber(light.size_px) + " px, ratio " +
           shortNumber(light.slimness) + ", contrast " + shortNumber(light.contrast);
  }
  static std::string lostLine(const PlacedLight& disc, const product::Detection& found) {
    for (const auto& light : found.rejected_lights)
      if ((light.position_px - disc.centre_px).norm() < disc.radius_px)
        return "lost " + describe(disc) + ": " + std::string(product::id(light.reason));
    return "lost " + describe(disc);
  }
  static std::string falseLine(const product::DetectedMarker& marker, const SpuriousFrame& frame) {
    const auto distance = [&](const PlacedLight& light) {
      return (light.centre_px - marker.centre_px).norm();
    };
    return "false marker at " + shortNumber(marker.centre_px.x()) + " " + shortNumber(marker.centre_px.y()) +
           (marker.cut ? ", flagged as cut, on " : " on ") +
           describe(*std::ranges::min_element(frame.lights, {}, distance)) + ", noise " +
           shortNumber(frame.noise);
  }

  std::filesystem::path folder_;
  std::mutex guard_;
  int discs_ = 0, lost_ = 0, false_ = 0;
  std::map<std::uint64_t, Picture> pictures_;
};

}  // namespace

void measureRecall(Run& run) {
  const int frames = run.trials(30000, 300);
  const SpuriousScene scene(run.options.quick);
  Tally tally(run.options.out / "failures");
  forEachTrial(frames, [&] {
    return [&, finder = product::MarkerFinder(product::FinderSettings{})](int index) mutable {
      const auto frame = scene.frame(static_cast<std::uint64_t>(index));
      tally.take(static_cast<std::uint64_t>(index), frame, finder.find(frame.image.view()));
    };
  });
  tally.savePictures();
  const double recall = 1.0 - static_cast<double>(tally.lost()) / tally.discs();
  const double false_rate = static_cast<double>(tally.falseDiscs()) / frames;
  run.report.rows.push_back({"",
                             "recall",
                             ">= 99.9 %",
                             {{"found", 100.0 * recall, "%"}},
                             {{"discs", 1.0 * tally.discs(), ""}, {"lost", 1.0 * tally.lost(), ""}},
                             recall >= 0.999});
  run.report.rows.push_back({"",
                             "false discs a frame, 20 spurious reflections",
                             "<= 0.0001",
                             {{"mean", false_rate, ""}},
                             {{"frames", 1.0 * frames, ""},
                              {"false discs", 1.0 * tally.falseDiscs(), ""},
                              {"upper 95 % limit", poissonUpperLimit(tally.falseDiscs()) / frames, ""}},
                             false_rate <= 1e-4});
}

}  // namespace mirrorarm::benchmarks::vision
