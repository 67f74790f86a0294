#include <numbers>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/vision/ellipse_fit.h"

namespace mirrorarm::vision {
namespace {

const EllipseMap kTruth{{412.3, 288.7}, (Eigen::Matrix2d() << 6.0, 1.2, 1.2, 4.0).finished()};

std::vector<Eigen::Vector2d> pointsOn(const EllipseMap& ellipse, int count, double sigma,
                                      std::mt19937& random, double arc = 2.0 * std::numbers::pi) {
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double a = arc * i / count;
    points.emplace_back(ellipse.centre + ellipse.axes * Eigen::Vector2d(std::cos(a), std::sin(a)) +
                        sigma * Eigen::Vector2d(noise(random), noise(random)));
  }
  return points;
}

Eigen::Matrix2d shape(const EllipseMap& ellipse) { return ellipse.axes * ellipse.axes.transpose(); }

TEST(EllipseFit, DirectFitIsExactOnAnExactEllipse) {
  std::mt19937 random(1);
  for (const double arc : {6.28, 3.0, 2.0}) {
    const auto fit = fitDirect(pointsOn(kTruth, 40, 0.0, random, arc));
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->centre - kTruth.centre).norm(), 1e-6);
    EXPECT_LT((shape(*fit) - shape(kTruth)).norm(), 1e-5);
  }
}

TEST(EllipseFit, DirectFitOfACircleIsStable) {
  std::mt19937 random(2);
  const EllipseMap circle{{10.0, 20.0}, 5.0 * Eigen::Matrix2d::Identity()};
  for (const int count : {6, 40, 400}) {
    const auto fit = fitDirect(pointsOn(circle, count, 0.0, random));
    ASSERT_TRUE(fit) << count;
    EXPECT_LT((fit->centre - circle.centre).norm(), 1e-7);
  }
}

TEST(EllipseFit, RefusesWhatIsNoEllipse) {
  std::vector<Eigen::Vector2d> line, few, same(20, Eigen::Vector2d(3, 4));
  for (int i = 0; i < 20; ++i) line.emplace_back(i, 2 * i);
  for (int i = 0; i < 5; ++i) few.emplace_back(std::cos(i), std::sin(i));
  EXPECT_FALSE(fitDirect(line));
  EXPECT_FALSE(fitDirect(few));
  EXPECT_FALSE(fitDirect(same));
  EXPECT_FALSE(fitDirect({}));
}

TEST(EllipseFit, CentreScattersAsTheCofactorSays) {
  std::mt19937 random(3);
  const double sigma = 0.05;
  EllipseRefiner refiner;
  std::vector<char> supports;
  double normalised = 0.0;
  const int trials = 400;
  for (int i = 0; i < trials; ++i) {
    const auto points = pointsOn(kTruth, 40, sigma, random);
    const auto fit = refiner.refine(*fitDirect(points), points, 1.0, supports);
    ASSERT_TRUE(fit);
    const Eigen::Vector2d error = fit->ellipse.centre - kTruth.centre;
    normalised += error.dot((sigma * sigma * fit->cofactor).inverse() * error);
  }
  EXPECT_NEAR(normalised / trials, 2.0, 0.3);
}

TEST(EllipseFit, RefiningDropsPointsThatLieOff) {
  std::mt19937 random(4);
  auto points = pointsOn(kTruth, 60, 0.02, random);
  for (std::size_t i = 0; i < points.size(); i += 8) points[i] += 0.2 * (points[i] - kTruth.centre);
  EllipseRefiner refiner;
  std::vector<char> supports;
  const auto fit = refiner.refine(*fitDirect(points), points, 0.1, supports);
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->ellipse.centre - kTruth.centre).norm(), 0.05);
  for (std::size_t i = 0; i < points.size(); i += 8) EXPECT_EQ(supports[i], 0);
}

}  // namespace
}  // namespace mirrorarm::vision
