#include <functional>
#include <numbers>

#include "benchmarks/calibration/suite.h"
#include "core/calibration/hand_eye.h"
#include "tests/calibration/stations.h"

namespace mirrorarm::benchmarks::calibration {
namespace {

using namespace mirrorarm::calibration;
using Pairs = std::vector<PosePair>;

/// An answer farther off than that is wrong.
constexpr double kRight_m = 0.005;
constexpr double kRight_rad = 0.5 * std::numbers::pi / 180.0;

struct Outcome {
  int resolved = 0;
  int refused = 0;
  int wrong = 0;
};

Outcome outcomeOf(int trials, const std::function<Pairs(StationMaker&)>& make) {
  Outcome outcome;
  for (int i = 0; i < trials; ++i) {
    StationMaker maker;
    maker.noise_m = 3e-4;
    maker.noise_deg = 0.03;
    maker.random.seed(static_cast<std::mt19937::result_type>(kSeed) + static_cast<unsigned>(i));
    const auto solved = solveHandEye(make(maker), CameraMount::kInHand);
    if (!solved)
      ++outcome.refused;
    else if ((solved->X_PC.translation() - maker.X_FC.translation()).norm() < kRight_m &&
             angleBetween(solved->X_PC, maker.X_FC) < kRight_rad)
      ++outcome.resolved;
    else
      ++outcome.wrong;
  }
  return outcome;
}

void add(Run& run, const std::string& name, const std::function<Pairs(StationMaker&)>& make) {
  const auto outcome = outcomeOf(run.trials(200, 10), make);
  run.report.rows.push_back({"",
                             name,
                             "refused or resolved",
                             {{"wrong answers", static_cast<double>(outcome.wrong), ""},
                              {"refused", static_cast<double>(outcome.refused), ""},
                              {"resolved", static_cast<double>(outcome.resolved), ""}},
                             {},
                             outcome.wrong == 0});
}

Pairs with(Pairs pairs, const std::function<void(PosePair&)>& change) {
  for (auto& pair : pairs) change(pair);
  return pairs;
}

/// A board of 0.2 by 0.15 m looks alike after half a turn about its middle.
RigidTransform halfTurn() {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
  return makeTransform(turn, {0.20, 0.15, 0.0});
}

}  // namespace

void measureRefusals(Run& run) {
  add(run, "turned about one axis only", [](StationMaker& maker) { return maker.stationsAboutOneAxis(15); });
  add(run, "three stations, 3 degrees apart", [](StationMaker& maker) {
    maker.smallest_turn_deg = 0.0;
    maker.largest_turn_deg = 3.0;
    return maker.stations(3);
  });
  add(run, "robot's poses inverted", [](StationMaker& maker) {
    return with(maker.stations(15), [](PosePair& pair) { pair.X_BF = pair.X_BF.inverse(); });
  });
  add(run, "camera's poses inverted", [](StationMaker& maker) {
    return with(maker.stations(15), [](PosePair& pair) { pair.X_CM = pair.X_CM.inverse(); });
  });
  add(run, "both inverted", [](StationMaker& maker) {
    return with(maker.stations(15), [](PosePair& pair) {
      pair.X_BF = pair.X_BF.inverse();
      pair.X_CM = pair.X_CM.inverse();
    });
  });
  add(run, "the board seen half a turn round by a third of the stations", [](StationMaker& maker) {
    auto pairs = maker.stations(15);
    for (std::size_t i = 0; i < pairs.size(); i += 3) pairs[i].X_CM = pairs[i].X_CM * halfTurn();
    return pairs;
  });
}

}  // namespace mirrorarm::benchmarks::calibration
