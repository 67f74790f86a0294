#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "core/tracking/layout.h"
#include "core/tracking/layout_report.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

Target targetOf(std::string name, std::vector<Vector3d> markers_mm) {
  Target target;
  target.name = std::move(name);
  for (const auto& p : markers_mm) target.markers_T.push_back(0.001 * p);
  return target;
}

/// The rigid bodies of a commercial tracker; empty when the file is absent.
std::map<std::string, Target> commercialBodies() {
  std::map<std::string, Target> bodies;
  std::ifstream in(std::filesystem::path(SHARED_DATA) / "plus-tracker" / "rom" / "markers_decoded.csv");
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const auto cells = splitCells(line, ',');
    Vector3d p_mm = Vector3d::Zero();
    if (cells.size() != 5 || !parseNumber(cells[2], p_mm[0]) || !parseNumber(cells[3], p_mm[1]) ||
        !parseNumber(cells[4], p_mm[2]))
      continue;
    auto& body = bodies[std::string(cells[0])];
    body.name = cells[0];
    body.markers_T.push_back(0.001 * p_mm);
  }
  return bodies;
}

}  // namespace

TEST(Layout, CommercialBodiesAreFineButTheLineAndTheKite) {
  const auto bodies = commercialBodies();
  if (bodies.empty()) GTEST_SKIP() << "shared data plus-tracker is absent";
  ASSERT_EQ(bodies.size(), 15u);
  for (const auto& [name, body] : bodies) {
    const LayoutReport report = checkLayout(body);
    if (name == "8700248.rom") {
      EXPECT_EQ(report.issues, std::vector{LayoutIssue::kCollinear});
    } else if (name == "P4_001.rom") {
      EXPECT_EQ(report.issues, std::vector{LayoutIssue::kPlanarAmbiguous});
      EXPECT_NEAR(report.symmetric_rms_m, 0.0023, 0.0001);
      EXPECT_EQ(report.needed_markers, 4);
    } else {
      EXPECT_TRUE(report.issues.empty()) << describe(report, report.issues.front());
    }
  }
  std::vector<Target> all;
  for (const auto& [name, body] : bodies) all.push_back(body);
  // These two were built to the same plan.
  const auto pairs = findLookAlikes(all);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].a, "HoloLens.rom");
  EXPECT_EQ(pairs[0].b, "P4_003.rom");
  EXPECT_EQ(pairs[0].shared_markers, 4);
  EXPECT_EQ(pairs[0].needed_markers, 0);
}

TEST(Layout, AForearmIsFine) {
  const LayoutReport report = checkLayout(forearm());
  EXPECT_TRUE(report.issues.empty());
  EXPECT_EQ(report.markers, 10);
  EXPECT_GE(report.needed_markers, 4);
  EXPECT_LE(report.needed_markers, 5);
  EXPECT_LT(report.turn_sigma_rad, 0.001);
}

TEST(Layout, ASquareLooksTheSameTurnedAndTurnedOver) {
  const auto report = checkLayout(targetOf("square", {{0, 0, 0}, {60, 0, 0}, {60, 60, 0}, {0, 60, 0}}));
  EXPECT_TRUE(report.has(LayoutIssue::kSymmetric) || report.has(LayoutIssue::kPlanarAmbiguous));
  EXPECT_LT(report.symmetric_rms_m, 1e-9);
}

TEST(Layout, AMirrorPlaneAcrossASolidBodyDoesNoHarm) {
  // Mirrored in z, but no turn does that.
  const auto solid =
      targetOf("solid", {{0, 0, 0}, {70, 10, 0}, {20, 50, 30}, {20, 50, -30}, {45, -10, 40}, {45, -10, -40}});
  const auto report = checkLayout(solid);
  EXPECT_FALSE(report.has(LayoutIssue::kSymmetric) || report.has(LayoutIssue::kPlanarAmbiguous));
  // Four of them lie in a plane, where a mirror image is a turn.
  EXPECT_EQ(report.alike_markers, 4);
  const auto flat = targetOf("flat", {{-50, 0, 0}, {50, 0, 0}, {0, 40, 0}, {-20, -30, 0}, {20, -30, 0}});
  EXPECT_TRUE(checkLayout(flat).has(LayoutIssue::kPlanarAmbiguous));
}

TEST(Layout, APropellerIsSymmetricInSpace) {
  std::vector<Vector3d> blades;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 3.0;
    blades.emplace_back(50.0 * std::cos(angle), 50.0 * std::sin(angle), 10.0);
    blades.emplace_back(30.0 * std::cos(angle + 0.5), 30.0 * std::sin(angle + 0.5), -20.0);
  }
  const auto report = checkLayout(targetOf("propeller", blades));
  EXPECT_TRUE(report.has(LayoutIssue::kSymmetric));
  EXPECT_NE(describe(report, LayoutIssue::kSymmetric).find("propeller is symmetric"), std::string::npos);
}

TEST(Layout, TellsHowManyMarkersMustBeSeen) {
  // A square of four that looks the same in every turn, and two more that tell which it is.
  const auto target =
      targetOf("lid", {{0, 0, 0}, {60, 0, 0}, {60, 60, 0}, {0, 60, 0}, {25, 10, 30}, {80, 20, 15}});
  const auto report = checkLayout(target);
  EXPECT_EQ(report.issues, std::vector{LayoutIssue::kAlikeInPart});
  EXPECT_EQ(report.alike_markers, 4);
  EXPECT_EQ(report.needed_markers, 5);
}

TEST(Layout, NearLineNearMarkersAndSmallSpread) {
  EXPECT_TRUE(checkLayout(targetOf("rod", {{0, 0, 0}, {40, 4, 0}, {100, -4, 0}, {150, 3, 3}}))
                  .has(LayoutIssue::kNearlyCollinear));
  EXPECT_TRUE(checkLayout(targetOf("pair", {{0, 0, 0}, {9, 0, 0}, {60, 40, 0}, {20, 70, 20}}))
                  .has(LayoutIssue::kTooNear));
  EXPECT_TRUE(
      checkLayout(targetOf("button", {{0, 0, 0}, {16, 0, 0}, {5, 14, 0}})).has(LayoutIssue::kPoorTurn));
}

TEST(Layout, LookAlikesAreToldWithWhatTellsThemApart) {
  Noise noise(71);
  Target other = forearm();
  other.name = "upper arm";
  const RigidTransform X = noise.pose();
  for (auto& p : other.markers_T) p = X * p;
  for (std::size_t i = 6; i < 10; ++i) other.markers_T[i] += noise.gaussian(0.03);
  const std::vector<Target> targets{forearm(), other};
  const auto found = findLookAlikes(targets);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].shared_markers, 6);
  EXPECT_EQ(found[0].needed_markers, 7);
  const auto warnings = layoutWarnings(targets);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find("look_alike: forearm and upper arm"), 0u);
}

TEST(Layout, ALatticeOfManyMarkersEndsInBoundedWork) {
  std::vector<Vector3d> lattice;
  for (int i = 0; i < 64; ++i) lattice.emplace_back(20.0 * (i % 8), 20.0 * (i / 8), 0.0);
  const auto report = checkLayout(targetOf("lattice", lattice));
  EXPECT_FALSE(report.issues.empty());
}
