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
    int discs = 0, lost = 0;
    std::vector<Shape> made_up;
    for (const PlacedLight& light : frame.lights)
      if (light.shape == Shape::kDisc) {
        ++discs;
        lost += isFound(light, found) ? 0 : (faults.push_back(lostLine(light, found)), 1);
      }
    for (std::size_t i = 0; i < found.markers.size(); ++i)
      if (!isTrue(i, frame, found)) {
        made_up.push_back(nearestLight(found.markers[i], frame).shape);
        faults.push_back(falseLine(found.markers[i], frame));
      }
    const std::scoped_lock lock(guard_);
    discs_ += discs;
    lost_ += lost;
    for (const Shape shape : made_up) ++false_[shape];
    if (!faults.empty() && pictures_.size() < kMostPictures) pictures_[index] = {frame.image, faults};
  }

  [[nodiscard]] int discs() const { return discs_; }
  [[nodiscard]] int lost() const { return lost_; }
  /// How many false discs each shape made.
  [[nodiscard]] const std::map<Shape, int>& falseDiscs() const { return false_; }

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
  static const PlacedLight& nearestLight(const product::DetectedMarker& marker, const SpuriousFrame& frame) {
    const auto distance = [&](const PlacedLight& light) {
      return (light.centre_px - marker.centre_px).norm();
    };
    return *std::ranges::min_element(frame.lights, {}, distance);
  }
  static std::string falseLine(const product::DetectedMarker& marker, const SpuriousFrame& frame) {
    return "false marker at " + shortNumber(marker.centre_px.x()) + " " + shortNumber(marker.centre_px.y()) +
           (marker.cut ? ", flagged as cut, on " : " on ") + describe(nearestLight(marker, frame)) +
           ", noise " + shortNumber(frame.noise);
  }

  std::filesystem::path folder_;
  std::mutex guard_;
  int discs_ = 0, lost_ = 0;
  std::map<Shape, int> false_;
  std::map<std::uint64_t, Picture> pictures_;
};

Row recallRow(const Tally& tally) {
  constexpr double kLeast = 0.999;
  const double recall = 1.0 - static_cast<double>(tally.lost()) / tally.discs();
  Row row;
  row.name = "recall";
  row.goal = ">= 99.9 %";
  row.measured = {{"found", 100.0 * recall, "%"}};
  row.references = {{"discs", 1.0 * tally.discs(), ""}, {"lost", 1.0 * tally.lost(), ""}};
  row.pass = recall >= kLeast;
  return row;
}

Row falseRow(const Tally& tally, int frames) {
  constexpr double kMost = 1e-4;
  int count = 0;
  Row row;
  for (const auto& [shape, times] : tally.falseDiscs()) {
    row.references.push_back({"on " + std::string(id(shape)), 1.0 * times, ""});
    count += times;
  }
  const double rate = static_cast<double>(count) / frames;
  row.name = "false discs a frame, 20 spurious reflections";
  row.goal = "<= 0.0001";
  row.measured = {{"mean", rate, ""}, {"upper 95 % limit", poissonUpperLimit(count) / frames, ""}};
  row.references.insert(row.references.begin(),
                        {{"frames", 1.0 * frames, ""}, {"false discs", 1.0 * count, ""}});
  row.pass = rate <= kMost;
  return row;
}

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
  run.report.rows.push_back(recallRow(tally));
  run.report.rows.push_back(falseRow(tally, frames));
}

}  // namespace mirrorarm::benchmarks::vision
