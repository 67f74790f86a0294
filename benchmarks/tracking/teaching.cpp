#include <algorithm>
#include <limits>

#include <Eigen/LU>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/timing.h"
#include "benchmarks/tracking/lesson_scene.h"
#include "benchmarks/tracking/suite.h"
#include "benchmarks/vision/stereo_discs.h"
#include "core/geometry/rigid_fit.h"
#include "core/tracking/teacher.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

namespace product = mirrorarm::tracking;
using Eigen::Vector3d;

constexpr int kFrames = 200;
constexpr int kSixMotions = 6;
constexpr std::uint64_t kStream = 110;

/// A taught model against the true one, in the taught frame, once the two are laid on each other.
struct Errors {
  bool complete = false;  ///< every marker found, nothing else
  std::vector<Vector3d> of_marker_T;
  std::vector<int> taught_of_marker;
};

Errors errorsOf(const std::vector<Vector3d>& taught_T, const Layout& truth_T,
                const RigidTransform& X_CT_first) {
  Errors errors;
  Vector3d origin = Vector3d::Zero();
  for (const auto& p : truth_T) origin += X_CT_first * p / static_cast<double>(truth_T.size());
  std::vector<Vector3d> y;
  for (const auto& p : truth_T) {
    const Vector3d expected = X_CT_first * p - origin;
    const auto nearest = std::ranges::min_element(
        taught_T, {}, [&](const Vector3d& q) { return (q - expected).squaredNorm(); });
    y.push_back(*nearest);
    errors.taught_of_marker.push_back(static_cast<int>(nearest - taught_T.begin()));
  }
  const RigidTransform X = fitByKabsch(truth_T, y);
  for (std::size_t i = 0; i < y.size(); ++i) errors.of_marker_T.push_back(y[i] - X * truth_T[i]);
  auto distinct = errors.taught_of_marker;
  std::ranges::sort(distinct);
  errors.complete =
      taught_T.size() == truth_T.size() && std::ranges::adjacent_find(distinct) == distinct.end();
  return errors;
}

/// What the paper does: every cloud is laid on the running mean and enters it. It is told which point is
/// which marker, so that it is judged for its precision alone.
std::vector<Vector3d> runningMean(const LessonScene& scene) {
  const LessonFrame& first = scene.frames.front();
  std::vector<Vector3d> mean_T(scene.markers_T.size());
  std::vector<int> seen(mean_T.size(), 0);
  Vector3d origin = Vector3d::Zero();
  for (const auto& p : scene.markers_T) origin += first.X_CT * p / static_cast<double>(mean_T.size());
  for (const auto& frame : scene.frames) {
    std::vector<Vector3d> x, y;
    for (std::size_t k = 0; k < frame.cloud.size(); ++k) {
      const int marker = frame.marker_of_point[k];
      if (marker < 0 || (&frame != &first && seen[static_cast<std::size_t>(marker)] == 0)) continue;
      x.push_back(&frame == &first ? Vector3d(frame.cloud[k].p_C - origin)
                                   : mean_T[static_cast<std::size_t>(marker)]);
      y.push_back(frame.cloud[k].p_C);
    }
    if (x.size() < 3) continue;
    const RigidTransform X_TC = fitByKabsch(x, y).inverse();
    for (std::size_t k = 0; k < frame.cloud.size(); ++k) {
      if (frame.marker_of_point[k] < 0) continue;
      const auto marker = static_cast<std::size_t>(frame.marker_of_point[k]);
      mean_T[marker] += (X_TC * frame.cloud[k].p_C - mean_T[marker]) / ++seen[marker];
    }
  }
  return mean_T;
}

/// Of one lesson.
struct Outcome {
  Errors taught, mean;
  double normalised = 0.0;  ///< sum of e' C^-1 e over the markers
  double sigma_m = 0.0;
  int left_out = 0;
  int done_after = -1;  ///< frames; -1: not within the lesson
};

Outcome teachOnce(const camera::StereoRig& rig, int index) {
  TrialRandom random(kSeed, kStream, static_cast<std::uint64_t>(index));
  const LessonScene scene = lessonScene(rig, kFrames, random);
  product::Teacher teacher{product::TeacherSettings{}};
  Outcome outcome;
  for (const auto& frame : scene.frames) {
    teacher.add(frame.cloud);
    if (outcome.done_after < 0 && teacher.isDone()) outcome.done_after = teacher.frames();
  }
  const RigidTransform& first = scene.frames.front().X_CT;
  outcome.mean = errorsOf(runningMean(scene), scene.markers_T, first);
  const auto taught = teacher.finish("taught");
  if (!taught) return outcome;
  outcome.taught = errorsOf(taught->target.markers_T, scene.markers_T, first);
  outcome.sigma_m = taught->sigma_m;
  outcome.left_out = taught->frames_rejected;
  for (std::size_t i = 0; i < scene.markers_T.size(); ++i) {
    const auto& C =
        taught->target.markers_covariance_m2[static_cast<std::size_t>(outcome.taught.taught_of_marker[i])];
    const Vector3d& e = outcome.taught.of_marker_T[i];
    outcome.normalised += e.dot(C.inverse() * e);
  }
  return outcome;
}

struct Summary {
  int complete = 0, left_out = 0, markers = 0;
  RootMeanSquare axis_m, distance_m, mean_distance_m, told_m;
  double worst_m = 0.0, mean_worst_m = 0.0, normalised = 0.0;
  std::vector<double> done_after;

  void add(const Outcome& outcome) {
    complete += outcome.taught.complete ? 1 : 0;
    left_out += outcome.left_out;
    if (outcome.done_after >= 0) done_after.push_back(outcome.done_after);
    told_m.addSquare(outcome.sigma_m * outcome.sigma_m);
    for (const auto& e : outcome.mean.of_marker_T) {
      mean_distance_m.addSquare(e.squaredNorm());
      mean_worst_m = std::max(mean_worst_m, e.norm());
    }
    normalised += outcome.normalised;
    for (const auto& e : outcome.taught.of_marker_T) {
      ++markers;
      axis_m.addSquare(e.squaredNorm(), 3);
      distance_m.addSquare(e.squaredNorm());
      worst_m = std::max(worst_m, e.norm());
    }
  }
};

Row precisionRow(const Summary& all, int lessons) {
  Row row;
  row.name = "10 markers, 200 frames, half of them with hidden markers, strangers";
  row.goal = "std per marker <= 10 um";
  row.measured = {{"rms of a marker", 1e6 * all.distance_m.value(), "um"},
                  {"per axis", 1e6 * all.axis_m.value(), "um"},
                  {"worst marker", 1e6 * all.worst_m, "um"},
                  {"complete", 100.0 * all.complete / lessons, "%"},
                  {"frames left out", 1.0 * all.left_out / lessons, ""}};
  row.references = {{"running mean, identities given", 1e6 * all.mean_distance_m.value(), "um"},
                    {"its worst", 1e6 * all.mean_worst_m, "um"},
                    {"lessons", 1.0 * lessons, ""}};
  row.pass = all.complete == lessons && all.distance_m.value() <= 10e-6;
  return row;
}

Row honestyRow(const Summary& all, int lessons) {
  // Of the markers' coordinates all but a common motion are free.
  const int freedom = 3 * all.markers / lessons - kSixMotions;
  const Interval per_lesson = chiSquareMeanBand(freedom, lessons);
  const double scale = 3.0 / freedom;
  const Interval band{scale * per_lesson.low, scale * per_lesson.high};
  const double mean = all.normalised / all.markers;
  Row row;
  row.name = "honesty of the markers' covariance";
  row.goal = "mean of e'C^-1 e from " + shortNumber(band.low) + " to " + shortNumber(band.high);
  row.measured = {{"mean", mean, ""}, {"told std, least sure direction", 1e6 * all.told_m.value(), "um"}};
  row.pass = band.holds(mean);
  return row;
}

Row doneRow(const Summary& all, int lessons) {
  Row row;
  row.name = "done by itself at 10 um";
  row.goal = "within 200 frames, always";
  row.measured = {{"median", quantile(all.done_after, 0.5), "frames"},
                  {"latest", quantile(all.done_after, 1.0), "frames"},
                  {"done", 100.0 * static_cast<double>(all.done_after.size()) / lessons, "%"}};
  row.pass = static_cast<int>(all.done_after.size()) == lessons;
  return row;
}

Row timeRow(const camera::StereoRig& rig, int lessons) {
  std::vector<double> adding_ms, finishing_ms;
  for (int i = 0; i < lessons; ++i) {
    TrialRandom random(kSeed, kStream + 1, static_cast<std::uint64_t>(i));
    const LessonScene scene = lessonScene(rig, kFrames, random);
    product::Teacher teacher{product::TeacherSettings{}};
    for (const auto& frame : scene.frames) {
      const TimePoint start = Clock::now();
      teacher.add(frame.cloud);
      adding_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
    }
    const TimePoint start = Clock::now();
    const auto taught = teacher.finish("taught");
    finishing_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
  }
  Row row;
  row.name = "time of a frame of the lesson, and of its end";
  row.measured = {{"median", quantile(adding_ms, 0.5), "ms"},
                  {"p99", quantile(adding_ms, 0.99), "ms"},
                  {"longest", quantile(adding_ms, 1.0), "ms"},
                  {"end, median", quantile(finishing_ms, 0.5), "ms"}};
  return row;
}

}  // namespace

void measureTeaching(Run& run) {
  const camera::StereoRig rig = vision::fisheyeRig();
  const int lessons = run.trials(300, 6);
  std::vector<Outcome> outcomes(static_cast<std::size_t>(lessons));
  forEachTrial(lessons, [&] {
    return [&](int index) { outcomes[static_cast<std::size_t>(index)] = teachOnce(rig, index); };
  });
  Summary all;
  for (const auto& outcome : outcomes) all.add(outcome);
  run.report.rows.push_back(precisionRow(all, lessons));
  run.report.rows.push_back(honestyRow(all, lessons));
  run.report.rows.push_back(doneRow(all, lessons));
  run.report.rows.push_back(timeRow(rig, run.trials(20, 2)));
}

}  // namespace mirrorarm::benchmarks::tracking
