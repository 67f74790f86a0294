#include <random>
#include <stdexcept>
#include <vector>

#include "benchmarks/robot/kdl_lma.h"
#include "benchmarks/robot/suite.h"
#include "benchmarks/timing.h"
#include "core/common/resources.h"
#include "core/robot/kinematics.h"
#include "core/robot/srs_postures.h"
#include "core/robot/urdf.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using namespace mirrorarm::robot;

constexpr double kMicroseconds = 1000.0;  // of a millisecond

/// A pose that some posture within the ranges has, and a seed that knows nothing of it.
struct Question {
  RigidTransform X_BF;
  Joints seed, neighbour;
};

class Questions {
 public:
  Questions(const ArmDescription& arm, int count) : ranges_(jointRanges(arm)), kinematics_(arm) {
    for (int i = 0; i < count; ++i) {
      const Joints q = posture();
      all_.push_back({kinematics_.flange(q), posture(),
                      (q + 0.05 * (posture() - q)).cwiseMax(ranges_.lower).cwiseMin(ranges_.upper)});
    }
  }
  [[nodiscard]] const Question& operator[](int i) const { return all_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool haveRange(const Joints& q) const { return ranges_.have(q); }
  [[nodiscard]] double misfit(const RigidTransform& X_BF, const Joints& q) const {
    return (kinematics_.flange(q).matrix() - X_BF.matrix()).cwiseAbs().maxCoeff();
  }

 private:
  Joints posture() {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return ranges_.lower.binaryExpr(
        ranges_.upper, [&](double low, double high) { return low + share(random_) * (high - low); });
  }

  std::mt19937 random_{static_cast<std::mt19937::result_type>(kSeed)};
  JointRanges ranges_;
  Kinematics kinematics_;
  std::vector<Question> all_;
};

/// What one way of solving did with all questions.
struct Tally {
  int solved = 0;  ///< within the ranges
  double worst = 0.0;
  Timing time;
};

template <class Solve>
Tally tally(const Questions& questions, int count, Solve solve) {
  Tally tally;
  std::vector<std::optional<Joints>> answers(static_cast<std::size_t>(count));
  tally.time = timed(count, [&](int i) { answers[static_cast<std::size_t>(i)] = solve(questions[i]); });
  for (int i = 0; i < count; ++i) {
    const auto& q = answers[static_cast<std::size_t>(i)];
    if (!q || !questions.haveRange(*q)) continue;
    ++tally.solved;
    tally.worst = std::max(tally.worst, questions.misfit(questions[i].X_BF, *q));
  }
  return tally;
}

std::vector<Figure> figures(const std::string& method, const Tally& tally, int count) {
  return {{method + " solved", 100.0 * tally.solved / count, "%"},
          {method + " worst error", tally.worst, ""},
          {method + " median", kMicroseconds * tally.time.median_ms, "us"},
          {method + " p99", kMicroseconds * tally.time.p99_ms, "us"}};
}

/// From one arm angle to all eight branches.
Row branchesRow(const SrsArm& srs, const Questions& questions, int count) {
  double worst = 0.0, sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto postures = SrsPostures::at(srs, questions[i].X_BF);
    if (!postures) throw std::runtime_error("a pose of the arm is said to be out of its reach");
    for (const Joints& q : postures->branches(0.3))
      worst = std::max(worst, questions.misfit(questions[i].X_BF, q));
  }
  const Timing time = timed(count, [&](int i) {
    for (const Joints& q : SrsPostures::at(srs, questions[i].X_BF)->branches(0.3)) sum += q[0];
  });
  if (!std::isfinite(sum)) throw std::runtime_error("a joint is no number");
  const double median_us = kMicroseconds * time.median_ms;
  return {
      "",
      "All eight branches at one arm angle",
      "<= 10 us, error <= 1e-9",
      {{"median", median_us, "us"}, {"p99", kMicroseconds * time.p99_ms, "us"}, {"worst error", worst, ""}},
      {},
      median_us <= 10.0 && worst <= 1e-9};
}

}  // namespace

void measureInverseKinematics(Run& run) {
  const int count = run.trials(20'000, 300);
  for (const std::string name : {"lbr4plus", "iiwa7", "iiwa14"}) {
    const auto arm = readUrdf(resourceFolder() / "robots" / (name + ".urdf"));
    if (!arm) throw std::runtime_error(describe(arm.error()));
    const Questions questions(*arm, count);
    const Kinematics kinematics(*arm);
    KdlLma lma(*arm);
    const auto valueOf = [](const Expected<Joints, NoPosture>& q) {
      return q ? std::optional<Joints>(*q) : std::nullopt;
    };
    const Tally reached = tally(questions, count, [&](const Question& asked) {
      return valueOf(kinematics.reach(asked.X_BF, asked.seed));
    });
    const Tally followed = tally(questions, count, [&](const Question& asked) {
      return valueOf(kinematics.follow(asked.X_BF, asked.neighbour));
    });
    const Tally by_kdl =
        tally(questions, count, [&](const Question& asked) { return lma.solve(asked.X_BF, asked.seed); });
    run.report.rows.push_back({"", name + ": poses in reach, seed unknown",
                               "100 % within ranges, error <= 1e-9", figures("closed form", reached, count),
                               figures("KDL LMA", by_kdl, count),
                               reached.solved == count && reached.worst <= 1e-9});
    run.report.rows.push_back(
        {"", name + ": continued from a neighbour", "", figures("closed form", followed, count), {}, {}});
    Row branches = branchesRow(*srsArm(*arm), questions, count);
    branches.name = name + ": " + branches.name;
    run.report.rows.push_back(std::move(branches));
  }
}

}  // namespace mirrorarm::benchmarks::robot
