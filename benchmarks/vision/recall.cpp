#include <algorithm>
#include <fstream>
#include <map>
#include <mutex>
#include <stdexcept>

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

std::string describe(const PlacedLight& light) {
  return std::string(id(light.shape)) + " at " + shortNumber(light.centre_px.x()) + " " +
         shortNumber(light.centre_px.y()) + ", " + shortNumber(light.size_px) + " px, ratio " +
         shortNumber(light.slimness) + ", contrast " + shortNumber(light.contrast);
}

std::string describe(const product::DetectedMarker& marker) {
  return "marker at " + shortNumber(marker.centre_px.x()) + " " + shortNumber(marker.centre_px.y()) +
         (marker.cut ? ", flagged as cut" : "");
}

const product::DetectedMarker* nearestMarker(const Eigen::Vector2d& at, const product::Detection& found) {
  const auto distance = [&](const product::DetectedMarker& marker) { return (marker.centre_px - at).norm(); };
  const auto marker = std::ranges::min_element(found.markers, {}, distance);
  return marker == found.markers.end() ? nullptr : &*marker;
}

const PlacedLight& nearestLight(const Eigen::Vector2d& at, const SpuriousFrame& frame) {
  const auto distance = [&](const PlacedLight& light) { return (light.centre_px - at).norm(); };
  return *std::ranges::min_element(frame.lights, {}, distance);
}

/// What the finder made of one frame.
struct Outcome {
  int discs = 0;
  int lost = 0;
  std::vector<Shape> made_up;       ///< on what its false discs lie
  std::vector<std::string> faults;  ///< a line each
};

void lookForDisc(const PlacedLight& disc, const product::Detection& found, Outcome& outcome) {
  ++outcome.discs;
  const auto* marker = nearestMarker(disc.centre_px, found);
  if (marker != nullptr && (marker->centre_px - disc.centre_px).norm() <= kSame_px) return;
  ++outcome.lost;
  std::string fault = "lost " + describe(disc);
  for (const auto& light : found.rejected_lights)
    if ((light.position_px - disc.centre_px).norm() < disc.radius_px)
      fault += ", " + std::string(product::id(light.reason));
  outcome.faults.push_back(fault);
}

/// A marker is true on a disc, unless another marker lies nearer to that disc.
void lookAtMarker(const product::DetectedMarker& marker, const SpuriousFrame& frame,
                  const product::Detection& found, Outcome& outcome) {
  const PlacedLight& light = nearestLight(marker.centre_px, frame);
  const bool on_disc = light.shape == Shape::kDisc && (light.centre_px - marker.centre_px).norm() <= kSame_px;
  if (on_disc && nearestMarker(light.centre_px, found) == &marker) return;
  outcome.made_up.push_back(light.shape);
  outcome.faults.push_back("false " + describe(marker) + ", on " + describe(light) + ", noise " +
                           shortNumber(frame.noise));
}

Outcome outcomeOf(const SpuriousFrame& frame, const product::Detection& found) {
  Outcome outcome;
  for (const PlacedLight& light : frame.lights)
    if (light.shape == Shape::kDisc) lookForDisc(light, found, outcome);
  for (const auto& marker : found.markers) lookAtMarker(marker, frame, found, outcome);
  return outcome;
}

/// Sums over all frames, and the first failing ones. Any thread may add.
class Tally {
 public:
  void add(int index, const SpuriousFrame& frame, const Outcome& outcome) {
    const std::scoped_lock lock(guard_);
    ++frames_;
    discs_ += outcome.discs;
    lost_ += outcome.lost;
    for (const Shape shape : outcome.made_up) ++false_[shape];
    if (outcome.faults.empty()) return;
    failures_[index] = {frame.image, outcome.faults};
    if (failures_.size() > kMostPictures) failures_.erase(std::prev(failures_.end()));
  }

  [[nodiscard]] Row recallRow() const;
  [[nodiscard]] Row falseRow() const;
  /// Failing frames and a line of why for each fault, for those who mend it.
  void saveFailures(const std::filesystem::path& folder) const;

 private:
  struct Failure {
    camera::GreyImage image;
    std::vector<std::string> faults;
  };

  std::mutex guard_;
  int frames_ = 0, discs_ = 0, lost_ = 0;
  std::map<Shape, int> false_;
  std::map<int, Failure> failures_;
};

Row Tally::recallRow() const {
  constexpr double kMost = 0.001;
  const double lost = static_cast<double>(lost_) / discs_;
  Row row;
  row.name = "recall";
  row.goal = ">= 99.9 % found";
  row.measured = {{"not found", 100.0 * lost, "%"}};
  row.references = {{"discs", 1.0 * discs_, ""}, {"lost", 1.0 * lost_, ""}};
  row.pass = lost <= kMost;
  return row;
}

Row Tally::falseRow() const {
  constexpr double kMost = 1e-4;
  int count = 0;
  for (const auto& [shape, times] : false_) count += times;
  const double rate = static_cast<double>(count) / frames_;
  Row row;
  row.name = "false discs a frame, 20 spurious reflections";
  row.goal = "<= 0.0001";
  row.measured = {{"mean", rate, ""}, {"upper 95 % limit", poissonUpperLimit(count) / frames_, ""}};
  row.references = {{"frames", 1.0 * frames_, ""}, {"false discs", 1.0 * count, ""}};
  for (const auto& [shape, times] : false_)
    row.references.push_back({"on " + std::string(id(shape)), 1.0 * times, ""});
  row.pass = rate <= kMost;
  return row;
}

void Tally::saveFailures(const std::filesystem::path& folder) const {
  std::filesystem::remove_all(folder);
  if (failures_.empty()) return;
  std::filesystem::create_directories(folder);
  std::ofstream why(folder / "failures.txt");
  for (const auto& [index, failure] : failures_) {
    const std::string name = "frame_" + std::to_string(index) + ".png";
    if (const auto written = camera::writeImage(folder / name, failure.image); !written)
      throw std::runtime_error(written.error());
    for (const auto& fault : failure.faults) why << name << ": " << fault << "\n";
  }
}

}  // namespace

void measureRecall(Run& run) {
  const SpuriousScene scene(run.options.quick);
  Tally tally;
  forEachTrial(run.trials(30000, 300), [&] {
    return [&, finder = product::MarkerFinder(product::FinderSettings{})](int index) mutable {
      const auto frame = scene.frame(static_cast<std::uint64_t>(index));
      tally.add(index, frame, outcomeOf(frame, finder.find(frame.image.view())));
    };
  });
  tally.saveFailures(run.options.out / "failures");
  run.report.rows.push_back(tally.recallRow());
  run.report.rows.push_back(tally.falseRow());
}

}  // namespace mirrorarm::benchmarks::vision
