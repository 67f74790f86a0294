#include <fstream>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "program.h"
#include "tests/tracking/real_forearm.h"

// Tracking and the experiments about it, through the program itself.
namespace mirrorarm::cli {
namespace {

using tracking::test::RealForearm;

void appendCloud(std::ostream& out, std::size_t index, const std::vector<Eigen::Vector3d>& points) {
  for (const auto& p : points)
    out << index << ',' << index * 10'000'000 << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
}

constexpr auto kCloudHeader = "index,time_ns,x_m,y_m,z_m\n";

std::string shapeFile(const test::ScratchFolder& scratch, const std::string& name,
                      const std::vector<Eigen::Vector3d>& markers) {
  const auto file = scratch / (name + ".yaml");
  std::ofstream out(file);
  out << "format: mirrorarm/target/1\nname: " << name << "\nmarker_diameter_m: 0.007\nmarkers_m:\n";
  for (const auto& p : markers) out << "  - [" << p.x() << ", " << p.y() << ", " << p.z() << "]\n";
  return file.string();
}

const std::vector<Eigen::Vector3d> kShape{{0.0, 0.0, 0.0},    {0.05, 0.0, 0.01},   {0.02, 0.07, 0.0},
                                          {-0.06, 0.02, 0.0}, {0.01, -0.04, 0.02}, {0.03, 0.03, 0.05}};

TEST(TrackingJobs, MarkersOfARealForearmKeepTheirIdentityAmongAllOfTheBody) {
  const auto trc = shared("pyomeca-upper-limb/markers.trc");
  if (!std::filesystem::exists(trc)) GTEST_SKIP() << trc << " is absent";
  const RealForearm forearm(trc);
  const test::ScratchFolder scratch;
  std::mt19937 rng(11);
  std::ofstream lesson(scratch / "lesson.csv"), body(scratch / "body.csv");
  lesson.precision(9);
  body.precision(9);
  lesson << kCloudHeader;
  body << kCloudHeader;
  for (std::size_t i = 0; i < 20; ++i) appendCloud(lesson, i, forearm.shuffled(i, false, rng).points_C);
  std::vector<RealForearm::Frame> frames;
  for (std::size_t i = 0; i < forearm.frames(); ++i) {
    frames.push_back(forearm.shuffled(i, true, rng));
    appendCloud(body, i, frames.back().points_C);
  }
  lesson.close();
  body.close();
  const auto target = (scratch / "forearm.yaml").string(), matches = (scratch / "matches.csv").string();
  const auto taught = run("teach --clouds " + (scratch / "lesson.csv").string() + " --out " + target);
  ASSERT_EQ(taught.exit_code, 0) << taught.err;
  const auto tracked = run("track --clouds " + (scratch / "body.csv").string() + " --target " + target +
                           " --matches " + matches + " --json --out " + (scratch / "poses.csv").string());
  ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
  EXPECT_EQ(tracked.json()["tracked_share"], 1.0);

  std::map<long long, std::map<std::string, std::string>> name_of_marker;  // by frame
  const auto table = CsvTable::read(matches).value();
  for (const auto& row : table.rows()) {
    const auto frame = static_cast<std::size_t>(std::stoll(row.cells[0]));
    const Eigen::Vector3d p(std::stod(row.cells[3]), std::stod(row.cells[4]), std::stod(row.cells[5]));
    for (std::size_t k = 0; k < frames[frame].points_C.size(); ++k)
      if ((frames[frame].points_C[k] - p).norm() < 1e-5)
        name_of_marker[static_cast<long long>(frame)][row.cells[2]] = frames[frame].names[k];
  }
  ASSERT_EQ(name_of_marker.size(), frames.size());
  for (const auto& [frame, names] : name_of_marker) {
    EXPECT_GE(names.size(), 10U) << frame;
    for (int marker = 0; marker < 10; ++marker)
      EXPECT_EQ(names.at(std::to_string(marker)), name_of_marker.begin()->second.at(std::to_string(marker)))
          << frame;
  }
}

TEST(TrackingJobs, ThePapersMethodCanBeAskedForAndOthersNot) {
  const test::ScratchFolder scratch;
  const auto target = shapeFile(scratch, "plate", kShape);
  std::ofstream clouds(scratch / "clouds.csv");
  clouds << kCloudHeader;
  for (std::size_t i = 0; i < 5; ++i) {
    auto points = kShape;
    for (auto& p : points) p += Eigen::Vector3d(0.01, 0.0, 0.5);
    appendCloud(clouds, i, points);
  }
  clouds.close();
  const std::string job = "track --clouds " + (scratch / "clouds.csv").string() + " --target " + target +
                          " --json --out " + (scratch / "poses.csv").string();
  for (const std::string method : {"softassign", "cliques"}) {
    const auto done = run(job + " --tracker " + method);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.json()["tracked_share"], 1.0) << method;
  }
  const auto refused = run(job + " --tracker guess");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("there is no tracker 'guess'"), std::string::npos);
}

TEST(TrackingJobs, CloudsWithoutTheTargetAreLostAndTargetsThatAreAlikeAreToldSo) {
  const test::ScratchFolder scratch;
  const auto first = shapeFile(scratch, "first", kShape), second = shapeFile(scratch, "second", kShape);
  std::ofstream clouds(scratch / "clouds.csv");
  clouds << kCloudHeader << "0,0,,,\n1,1000,0.1,0.1,0.5\n2,2000,nan,nan,nan\n";
  for (int i = 0; i < 40; ++i) clouds << "3,3000,0.1,0.1,0.5\n";
  clouds.close();
  const auto done = run("track --clouds " + (scratch / "clouds.csv").string() + " --target " + first +
                        " --target " + second + " --json --out " + (scratch / "poses.csv").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.json()["tracked_share"], 0.0);
  EXPECT_FALSE(done.json()["warnings"].empty());
  EXPECT_EQ(CsvTable::read(scratch / "poses.csv").value().rows().size(), 8U);
}

TEST(TrackingJobs, HalfOfTheMarkersCoveredIsMeasuredBesideThePaper) {
  const test::ScratchFolder scratch;
  const auto done = run("experiment occlusion --json --out " + (scratch / "out").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const auto result = done.json();
  EXPECT_EQ(result["covered_share"], 0.5);
  EXPECT_EQ(result["tracked_share"], 1.0);
  EXPECT_LT(result["fit_rms_mm"], 0.1);
  EXPECT_LT(result["rms_mm"], 0.1);
  EXPECT_EQ(result["rows"].size(), 6U);
  EXPECT_TRUE(std::filesystem::exists(scratch / "out/occlusion.md"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "out/occlusion.json"));
}

TEST(TrackingJobs, ComputingTimeIsMeasuredBesideThePaper) {
  const test::ScratchFolder scratch;
  const auto done = run("experiment timing --json --out " + (scratch / "out").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const auto result = done.json();
  for (const char* key : {"median_ms", "mean_ms", "std_ms", "p99_ms"}) EXPECT_GT(result[key], 0.0) << key;
  EXPECT_EQ(result["markers"], 10);
  EXPECT_GT(result["ours"]["tracked_share"], 0.99);
  EXPECT_TRUE(std::filesystem::exists(scratch / "out/timing.md"));
}

}  // namespace
}  // namespace mirrorarm::cli
