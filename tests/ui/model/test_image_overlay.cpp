#include <algorithm>

#include <gtest/gtest.h>

#include "tests/ui/fake_bench.h"
#include "ui/model/image_overlay.h"
#include "ui/model/tracking_presenter.h"
#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

using therapy::Phase;

class Overlays : public ::testing::Test {
 protected:
  StereoOverlay overlay() { return overlayOf(*station_.snapshot().frame, workplace_.rig); }
  TrackingState tracking() {
    TrackingPresenter presenter;
    presenter.show(station_.snapshot(), Clock::now());
    return presenter.state();
  }
  Workplace workplace_ = test::benchWorkplace();
  test::FakeStation station_{workplace_};
};

TEST_F(Overlays, TaughtMarkersCarryTheirNumbers) {
  for (const auto& mark : overlay().left.marks) EXPECT_TRUE(mark.label.isEmpty());
  station_.enter(Phase::kTaught);
  const auto taught = overlay();
  ASSERT_EQ(taught.right.marks.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(taught.left.marks[i].identity, static_cast<int>(i) + 1);
    EXPECT_EQ(taught.right.marks[i].label, QString::number(i + 1));
    EXPECT_FALSE(taught.left.marks[i].cut || taught.left.marks[i].ambiguous);
  }
  EXPECT_EQ(taught.right.epipolar_lines.size(), 10U);
}

// A line for every partner would be drawn over itself; it passes through what it explains.
TEST_F(Overlays, EpipolarLinesPassThroughTheirPartners) {
  station_.enter(Phase::kTaught);
  const auto right = overlay().right;
  for (std::size_t i = 0; i < right.epipolar_lines.size(); ++i) {
    double nearest_px = 1e9;
    const auto& line = right.epipolar_lines[i].points_px;
    for (std::size_t k = 1; k < line.size(); ++k) {
      const QPointF way = line[k] - line[k - 1], to = right.marks[i].centre_px - line[k - 1];
      const double along =
          std::clamp(QPointF::dotProduct(way, to) / std::max(QPointF::dotProduct(way, way), 1e-9), 0.0, 1.0);
      const QPointF off = to - along * way;
      nearest_px = std::min(nearest_px, std::hypot(off.x(), off.y()));
    }
    EXPECT_LT(nearest_px, 0.5);
  }
}

TEST_F(Overlays, CutAndAmbiguousDiscsSaySo) {
  station_.enter(Phase::kTaught);
  station_.clutter();
  const auto seen = overlay();
  EXPECT_TRUE(seen.left.marks[2].cut);
  EXPECT_TRUE(seen.left.marks[2].label.startsWith(QStringLiteral("3 ")));
  const auto ambiguous = [](const ImageOverlay& image) {
    return std::count_if(image.marks.begin(), image.marks.end(),
                         [](const auto& mark) { return mark.ambiguous; });
  };
  EXPECT_EQ(ambiguous(seen.left), 1);
  EXPECT_EQ(ambiguous(seen.right), 2);
  ASSERT_EQ(seen.right.epipolar_lines.size(), 11U) << "one for a disc, however many partners it has";
  EXPECT_TRUE(seen.right.epipolar_lines.back().ambiguous);
  EXPECT_FALSE(seen.right.epipolar_lines.front().ambiguous);
}

TEST_F(Overlays, WhatTheModelHasNamedIsNotAmbiguous) {
  station_.enter(Phase::kTaught);
  auto frame = *station_.snapshot().frame;
  for (auto& point : frame.observation.points) point.rivals = 1;
  for (const auto& mark : overlayOf(frame, workplace_.rig).right.marks) EXPECT_FALSE(mark.ambiguous);
  frame.targets.clear();
  for (const auto& mark : overlayOf(frame, workplace_.rig).right.marks) EXPECT_TRUE(mark.ambiguous);
}

TEST_F(Overlays, RefusedLightsSayWhySpecksDoNot) {
  station_.clutter();
  const auto left = overlay().left;
  const auto& lights = station_.shown.frame->observation.left.rejected_lights;
  ASSERT_EQ(left.refused.size(), lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const bool speck = lights[i].reason == vision::Rejection::kTooSmall;
    EXPECT_EQ(left.refused[i].reason, speck ? QString() : words(lights[i].reason));
    EXPECT_EQ(left.refused[i].extent_px, lights[i].extent_px);
  }
}

TEST_F(Overlays, TheLightOfBothImagesIsTold) {
  ASSERT_EQ(tracking().exposure.size(), 1) << "one line while nothing is wrong";
  EXPECT_FALSE(tracking().exposure[0].warns);
  EXPECT_EQ(tracking().refused, QStringLiteral("0"));
  EXPECT_TRUE(tracking().refused_reasons.isEmpty());
  station_.clutter();
  const auto state = tracking();
  ASSERT_EQ(state.exposure.size(), 2);
  EXPECT_FALSE(state.exposure[0].warns);
  EXPECT_TRUE(state.exposure[1].warns);
  const auto saturated = vision::ExposureWarning::kSaturated;
  EXPECT_TRUE(state.exposure[1].text.contains(words(saturated)));
  EXPECT_TRUE(state.exposure[1].text.contains(advice(saturated)));
  EXPECT_TRUE(state.accessible.contains(state.exposure[1].text)) << "also for those who hear the screen";
  EXPECT_EQ(state.refused, QStringLiteral("12")) << "six in either image; two specks each do not count";
  EXPECT_EQ(state.refused_reasons.count(QLatin1Char('\n')), 1) << "a line a camera";
  EXPECT_TRUE(state.refused_reasons.contains(QStringLiteral("2 ") + words(vision::Rejection::kTooSmall)));
}

TEST(VisionWords, EveryReasonHasItsOwn) {
  QStringList reasons;
  for (std::size_t i = 0; i < vision::kRejectionCount; ++i)
    reasons << words(static_cast<vision::Rejection>(i));
  EXPECT_FALSE(reasons.contains(QString()));
  EXPECT_EQ(reasons.removeDuplicates(), 0);
  for (const auto warning : {vision::ExposureWarning::kSaturated, vision::ExposureWarning::kBrightBackground,
                             vision::ExposureWarning::kTooDark}) {
    EXPECT_FALSE(words(warning).isEmpty());
    EXPECT_FALSE(advice(warning).isEmpty());
  }
}

}  // namespace
}  // namespace mirrorarm::ui
