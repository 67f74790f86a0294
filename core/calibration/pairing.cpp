#include "core/calibration/pairing.h"

#include <limits>

#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

/// Length that weighs the turn of a bar against its shift [m].
constexpr double kTurnLength_m = 0.5;
/// Bars that differ by more, as a share of the board's distance, are not of one rig: single cameras know
/// their focal length to a per cent or two.
constexpr double kSameBarShare = 0.03;
/// So many pairs more must come together before the given ones are called wrong.
constexpr std::size_t kLeastGain = 2;

double distance_m(const RigidTransform& a, const RigidTransform& b) {
  return (a.translation() - b.translation()).norm() + kTurnLength_m * angleBetween(a, b);
}

/// All bars that a left and a right view imply, whether of one moment or not.
class Bars {
 public:
  Bars(std::span<const RigidTransform> X_LM, std::span<const RigidTransform> X_RM) : views_(X_LM.size()) {
    std::vector<double> distances;
    for (const auto& left : X_LM) {
      const RigidTransform X_ML = left.inverse();
      for (const auto& right : X_RM) bars_.push_back(right * X_ML);
      distances.push_back(left.translation().norm());
    }
    same_m_ = kSameBarShare * median(std::move(distances));
  }
  [[nodiscard]] std::size_t views() const { return views_; }
  [[nodiscard]] const RigidTransform& at(const ImagePair& pair) const {
    return bars_[pair.left * views_ + pair.right];
  }
  [[nodiscard]] bool agree(const RigidTransform& bar, const ImagePair& pair) const {
    return distance_m(bar, at(pair)) < same_m_;
  }
  /// Every left view with the right one that fits the bar, where one does: its own, or else the best.
  [[nodiscard]] std::vector<ImagePair> pairsUnder(const RigidTransform& bar) const {
    std::vector<ImagePair> pairs;
    for (std::size_t left = 0; left < views_; ++left) {
      ImagePair best{left, left};
      for (std::size_t right = 0; right < views_ && !agree(bar, {left, left}); ++right)
        if (distance_m(bar, at({left, right})) < distance_m(bar, at(best))) best.right = right;
      if (agree(bar, best)) pairs.push_back(best);
    }
    return pairs;
  }

 private:
  std::size_t views_;
  std::vector<RigidTransform> bars_;
  double same_m_ = 0.0;
};

/// Nearest to all others of the given pairs, so that a bad view does no harm.
RigidTransform middleBar(const Bars& bars) {
  RigidTransform best = bars.at({0, 0});
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < bars.views(); ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < bars.views(); ++j) sum += distance_m(bars.at({i, i}), bars.at({j, j}));
    if (sum >= least) continue;
    least = sum;
    best = bars.at({i, i});
  }
  return best;
}

std::size_t agreeing(const Bars& bars, const RigidTransform& bar) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < bars.views(); ++i) count += bars.agree(bar, {i, i}) ? 1 : 0;
  return count;
}

std::vector<ImagePair> mostPairs(const Bars& bars) {
  std::vector<ImagePair> best;
  for (std::size_t left = 0; left < bars.views(); ++left)
    for (std::size_t right = 0; right < bars.views(); ++right) {
      auto pairs = bars.pairsUnder(bars.at({left, right}));
      if (pairs.size() > best.size()) best = std::move(pairs);
    }
  return best;
}

}  // namespace

BarVote voteForBar(std::span<const RigidTransform> X_LM, std::span<const RigidTransform> X_RM) {
  const Bars bars(X_LM, X_RM);
  BarVote vote{middleBar(bars), {}};
  const std::size_t as_given = agreeing(bars, vote.X_RC);
  if (as_given + kLeastGain > bars.views()) return vote;
  auto most = mostPairs(bars);
  if (most.size() < as_given + kLeastGain || 2 * most.size() <= bars.views()) return vote;
  std::erase_if(most, [](const ImagePair& pair) { return pair.left == pair.right; });
  vote.better = std::move(most);
  return vote;
}

}  // namespace mirrorarm::calibration
