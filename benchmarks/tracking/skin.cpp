#include <array>
#include <filesystem>
#include <iostream>
#include <limits>

#include "benchmarks/parallel.h"
#include "benchmarks/timing.h"
#include "benchmarks/tracking/skin_methods.h"
#include "benchmarks/tracking/suite.h"
#include "core/tracking/constellation_search.h"
#include "core/tracking/teacher.h"
#include "tests/tracking/real_forearm.h"
#include "tests/tracking/skin_play.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;
namespace product = mirrorarm::tracking;
namespace world = mirrorarm::tracking::test;

constexpr int kFrames = 720;        // half a minute
constexpr double kSettled_s = 7.0;  // after which the frame's wander counts
constexpr double kHideFrom_s = 6.0;
constexpr int kStrangers = 3;
constexpr int kReferenceEvery = 8;
constexpr double kRealSensor_m = 0.0002;

/// What one method made of one arm.
struct Tally {
  int frames = 0, tracked = 0, shown = 0, right = 0, wrong = 0;
  RootMeanSquare wander_m;

  template <class Points>
  void add(const world::SkinFrame& frame, bool is_tracked, const Points& point_of_marker) {
    ++frames;
    for (const int marker : frame.marker_of_point) shown += marker >= 0 ? 1 : 0;
    if (!is_tracked) return;
    ++tracked;
    for (std::size_t i = 0; i < world::SimulatedSkin::kMarkers; ++i)
      if (point_of_marker[i] >= 0)
        ++(frame.marker_of_point[static_cast<std::size_t>(point_of_marker[i])] == static_cast<int>(i)
               ? right
               : wrong);
  }
  void join(const Tally& other) {
    frames += other.frames;
    tracked += other.tracked;
    shown += other.shown;
    right += other.right;
    wrong += other.wrong;
    wander_m.join(other.wander_m);
  }
  [[nodiscard]] std::vector<Figure> figures(const std::string& method) const {
    return {{method + "tracked", 100.0 * tracked / frames, "%"},
            {method + "right", 100.0 * right / shown, "%"},
            {method + "wrong", 1.0 * wrong, ""},
            {method + "frame", 1e3 * wander_m.value(), "mm"}};
  }
};

struct Methods {
  Tally ours, paper, plain;
  int slips_told = 0;
  void join(const Methods& other) {
    ours.join(other.ours);
    paper.join(other.paper);
    plain.join(other.plain);
    slips_told += other.slips_told;
  }
};

std::vector<Vector3d> positions(const std::vector<product::CloudPoint>& cloud) {
  std::vector<Vector3d> points;
  for (const auto& point : cloud) points.push_back(point.p_C);
  return points;
}

world::SkinMotion ofSize(double best_fit_rms_m) {
  world::SkinMotion motion;
  motion.best_fit_rms_m = best_fit_rms_m;
  return motion;
}

/// All methods on one arm; the references, which are slow, in every eighth frame. They are given the bone's
/// true pose to start from each time.
Methods followArm(double size_m, int hidden, unsigned seed) {
  world::SimulatedSkin skin(ofSize(size_m), seed);
  const auto taught = skin.taughtAt(0.0);
  world::SkinLoop loop = world::loopAbout(skin);
  PaperRule paper;
  PlainFit plain;
  std::array<world::FrameWander, 3> wander;
  Methods all;
  for (int i = 0; i < kFrames; ++i) {
    const double t = world::SimulatedSkin::kFrame_s * i;
    const auto frame = skin.look(t, world::hiddenAt(t, hidden, kHideFrom_s), kStrangers);
    const auto points = positions(frame.cloud);
    const bool tracked = loop.track(frame.cloud, world::timeOf(frame));
    all.ours.add(frame, tracked, loop.fit->point_of_marker);
    all.slips_told += loop.event == product::SkinEvent::kSlipped ? 1 : 0;
    if (tracked && t > kSettled_s) wander[0].add(loop.X_CT, frame.X_CB);
    if (i % kReferenceEvery != 0) continue;
    const RigidAnswer by_paper = paper.track(taught.markers_T, points, frame.X_CB);
    const RigidAnswer by_plain = plain.track(taught.markers_T, points, frame.X_CB);
    all.paper.add(frame, by_paper.accepted, by_paper.point_of_marker);
    all.plain.add(frame, by_plain.accepted, by_plain.point_of_marker);
    if (t < kSettled_s) continue;
    if (by_paper.accepted) wander[1].add(by_paper.X_CT, frame.X_CB);
    if (by_plain.accepted) wander[2].add(by_plain.X_CT, frame.X_CB);
  }
  const auto note = [](Tally& tally, const world::FrameWander& of) {
    if (of.frames() > 0) tally.wander_m.addSquare(of.rms_m() * of.rms_m());
  };
  note(all.ours, wander[0]);
  note(all.paper, wander[1]);
  note(all.plain, wander[2]);
  return all;
}

Row armRow(Run& run, double size_m, int hidden) {
  const int arms = run.trials(10, 2);
  std::vector<Methods> of_arm(static_cast<std::size_t>(arms));
  forEachTrial(arms, [&] {
    return [&](int index) {
      of_arm[static_cast<std::size_t>(index)] =
          followArm(size_m, hidden, 100U + static_cast<unsigned>(index));
    };
  });
  Methods all;
  for (const Methods& each : of_arm) all.join(each);
  Row row;
  row.name = shortNumber(1e3 * size_m) + " mm skin" +
             (hidden > 0 ? ", " + std::to_string(hidden) + " of 10 hidden in turn" : "");
  row.goal = hidden > 0 ? "every frame, no wrong identity" : "every frame, every identity right";
  row.measured = all.ours.figures("");
  row.measured.push_back({"slips told", 1.0 * all.slips_told, ""});
  row.references = all.paper.figures("paper ");
  const auto of_plain = all.plain.figures("Kabsch+NN ");
  row.references.insert(row.references.end(), of_plain.begin(), of_plain.end());
  row.pass = all.ours.tracked == all.ours.frames && all.ours.wrong == 0 &&
             (hidden > 0 || all.ours.right == all.ours.shown);
  return row;
}

struct SlipTally {
  int slips = 0, told = 0, lost_frames = 0, wrong = 0, most_frames = 0;
};

/// The sleeve slips by 15 mm at some time in the middle of half a minute.
SlipTally slipArm(double size_m, int first, unsigned seed) {
  world::SimulatedSkin skin(ofSize(size_m), seed);
  world::SkinLoop loop = world::loopAbout(skin);
  const int when = 200 + static_cast<int>(100.0 * skin.uniform());
  const std::vector<char> none(world::SimulatedSkin::kMarkers, 0);
  Tally tally;
  int after = -1;
  for (int i = 0; i < kFrames / 2; ++i) {
    if (i == when) skin.slip(first, 0.015);
    const auto frame = skin.look(world::SimulatedSkin::kFrame_s * i, none, kStrangers);
    const bool tracked = loop.track(frame.cloud, world::timeOf(frame));
    tally.add(frame, tracked, loop.fit->point_of_marker);
    if (loop.event == product::SkinEvent::kSlipped && after < 0) after = i - when;
  }
  return {1, after >= 0 ? 1 : 0, tally.frames - tally.tracked, tally.wrong, after};
}

Row slipRow(Run& run, double size_m, int first) {
  const int arms = run.trials(20, 2);
  std::vector<SlipTally> of_arm(static_cast<std::size_t>(arms));
  forEachTrial(arms, [&] {
    return [&](int index) {
      of_arm[static_cast<std::size_t>(index)] = slipArm(size_m, first, 300U + static_cast<unsigned>(index));
    };
  });
  SlipTally all;
  for (const SlipTally& each : of_arm) {
    all.slips += each.slips;
    all.told += each.told;
    all.lost_frames += each.lost_frames;
    all.wrong += each.wrong;
    all.most_frames = std::max(all.most_frames, each.most_frames);
  }
  Row row;
  row.name = std::string("slip of ") + (first > 0 ? "4 of 10 markers" : "the whole sleeve") + ", " +
             shortNumber(1e3 * size_m) + " mm skin";
  row.goal = "told, no frame lost, no wrong identity";
  row.measured = {{"told", 100.0 * all.told / all.slips, "%"},
                  {"after at most", 1.0 * all.most_frames, "frames"},
                  {"lost", 1.0 * all.lost_frames, "frames"},
                  {"wrong", 1.0 * all.wrong, ""},
                  {"of", 1.0 * all.slips, ""}};
  row.pass = all.told == all.slips && all.lost_frames == 0 && all.wrong == 0;
  return row;
}

std::vector<product::CloudPoint> measured(const std::vector<Vector3d>& points_C) {
  std::vector<product::CloudPoint> cloud;
  for (const auto& p_C : points_C)
    cloud.push_back({p_C, kRealSensor_m * kRealSensor_m * Eigen::Matrix3d::Identity(), {}});
  return cloud;
}

/// Where a taught target lies in a frame, from nothing.
RigidTransform found(const product::Target& target, const std::vector<product::CloudPoint>& cloud) {
  product::ConstellationSettings wide;
  wide.tolerance_m = 0.002;
  product::ConstellationSearch search(wide);
  search.setTargets(std::array{std::span<const Vector3d>(target.markers_T)});
  const auto results = search.run(cloud);
  if (results[0].verdict != product::SearchVerdict::kFound)
    throw std::runtime_error("the real forearm was not found in its first frame");
  return results[0].best.X_CT;
}

/// Right means that all ten were found and each is its own.
struct RealTally {
  int ours = 0, paper = 0, plain = 0;
};

RealTally followRealArm(const world::RealForearm& forearm, unsigned seed) {
  std::mt19937 rng(seed);
  product::Teacher teacher{product::TeacherSettings{}};
  for (std::size_t i = 0; i < 20; ++i) teacher.add(measured(forearm.shuffled(i, false, rng).points_C));
  const auto taught = teacher.finish("forearm");
  if (!taught) throw std::runtime_error("the real forearm could not be taught");
  const auto& target = taught->target;
  const RigidTransform X_CT = found(target, measured(forearm.shuffled(0, true, rng).points_C));
  world::SkinLoop loop(target, X_CT, X_CT);
  PaperRule paper;
  PlainFit plain;
  RigidTransform of_paper = X_CT, of_plain = X_CT;
  world::IdentityCheck check_ours, check_paper, check_plain;
  RealTally tally;
  for (std::size_t i = 0; i < forearm.frames(); ++i) {
    const auto frame = forearm.shuffled(i, true, rng);
    const TimePoint time(toClock(Seconds(1.0 + world::RealForearm::kFrame_s * static_cast<double>(i))));
    const std::size_t markers = target.markers_T.size();
    const bool tracked = loop.track(measured(frame.points_C), time);
    tally.ours += tracked && check_ours.add(loop.fit->point_of_marker, markers, frame.names) ? 1 : 0;
    const RigidAnswer by_paper = paper.track(target.markers_T, frame.points_C, of_paper);
    if (by_paper.accepted) of_paper = by_paper.X_CT;
    tally.paper += by_paper.accepted && check_paper.add(by_paper.point_of_marker, markers, frame.names);
    const RigidAnswer by_plain = plain.track(target.markers_T, frame.points_C, of_plain);
    if (by_plain.accepted) of_plain = by_plain.X_CT;
    tally.plain += by_plain.accepted && check_plain.add(by_plain.point_of_marker, markers, frame.names);
  }
  return tally;
}

void addRealArm(Run& run) {
  const world::RealForearm forearm(std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb" / "markers.trc");
  if (forearm.frames() == 0) {
    std::cerr << "skin: no recorded forearm in " << SHARED_DATA << ", its row is left out\n";
    return;
  }
  RealTally all;
  const int orders = run.trials(5, 1);
  for (int i = 0; i < orders; ++i) {
    const RealTally each = followRealArm(forearm, static_cast<unsigned>(i));
    all.ours += each.ours;
    all.paper += each.paper;
    all.plain += each.plain;
  }
  const double frames = static_cast<double>(forearm.frames()) * orders;
  Row row;
  row.name = "real forearm among 51 markers";
  row.goal = "every identity in every frame";
  row.measured = {{"frames all right", 100.0 * all.ours / frames, "%"}, {"of", frames, "frames"}};
  row.references = {{"paper", 100.0 * all.paper / frames, "%"},
                    {"Kabsch+NN", 100.0 * all.plain / frames, "%"}};
  row.pass = all.ours == static_cast<int>(frames);
  run.report.rows.push_back(row);
}

void addTime(Run& run) {
  world::SimulatedSkin skin(ofSize(0.005), 1);
  world::SkinLoop loop = world::loopAbout(skin);
  const std::vector<char> none(world::SimulatedSkin::kMarkers, 0);
  std::vector<double> times_ms;
  for (int i = 0; i < run.trials(2000, 100); ++i) {
    const auto frame = skin.look(world::SimulatedSkin::kFrame_s * i, none, kStrangers);
    if (!loop.track(frame.cloud, world::timeOf(frame))) break;
    const std::vector<char> taken(frame.cloud.size(), 0);
    const TimePoint later = world::timeOf(frame) + std::chrono::milliseconds(5), start = Clock::now();
    loop.skin.predict(later);
    (void)loop.skin.observe({later, loop.X_CT, frame.cloud, loop.fit->point_of_marker, taken, {}});
    times_ms.push_back(1000.0 * secondsBetween(start, Clock::now()));
  }
  Row row;
  row.name = "time of the model a frame, 10 markers";
  row.measured = {{"median", 1e3 * quantile(times_ms, 0.5), "us"},
                  {"p99", 1e3 * quantile(times_ms, 0.99), "us"}};
  run.report.rows.push_back(row);
}

}  // namespace

void measureSkin(Run& run) {
  addRealArm(run);
  for (const double size_m : {0.002, 0.005, 0.008}) run.report.rows.push_back(armRow(run, size_m, 0));
  for (const double size_m : {0.002, 0.005, 0.008}) run.report.rows.push_back(armRow(run, size_m, 3));
  run.report.rows.push_back(armRow(run, 0.002, 5));
  for (const int first : {6, 0})
    for (const double size_m : {0.002, 0.005, 0.008}) run.report.rows.push_back(slipRow(run, size_m, first));
  addTime(run);
}

}  // namespace mirrorarm::benchmarks::tracking
