#include "core/therapy/path_lag.h"

#include <algorithm>
#include <cmath>

#include "core/common/quantile.h"

namespace mirrorarm::therapy {
namespace {

constexpr double kLeastMovement_m = 0.002;
constexpr double kLeastJudged_s = 0.4;
constexpr double kLeastStep_s = 0.002;

/// Evenly resampled pair.
struct EvenPaths {
  std::vector<Eigen::Vector3d> goal, reached;
};

double medianInterval(std::span<const PathPair> pieces) {
  std::vector<double> intervals;
  for (const auto& piece : pieces)
    for (std::size_t i = 1; i < piece.time_s.size(); ++i)
      intervals.push_back(piece.time_s[i] - piece.time_s[i - 1]);
  return intervals.empty() ? 0.0 : quantile(std::move(intervals), 0.5);
}

EvenPaths resampled(const PathPair& piece, double step_s) {
  EvenPaths even;
  const double first = piece.time_s.front();
  const auto count = static_cast<int>((piece.time_s.back() - first) / step_s + 1e-6) + 1;
  for (int i = 0; i < count; ++i) {
    even.goal.push_back(pointAt(piece.time_s, piece.goal, first + i * step_s));
    even.reached.push_back(pointAt(piece.time_s, piece.reached, first + i * step_s));
  }
  return even;
}

/// The shifts tried, in steps, and the pieces long enough to be judged over the same instants in all of them.
class ShiftSearch {
 public:
  ShiftSearch(std::span<const PathPair> pieces, double step_s)
      : least_(static_cast<int>(std::floor(kLeastLag_s / step_s))),
        largest_(static_cast<int>(std::ceil(kLargestLag_s / step_s))) {
    const double needed_s = kLargestLag_s - kLeastLag_s + kLeastJudged_s;
    for (const auto& piece : pieces)
      if (!piece.time_s.empty() && piece.time_s.back() - piece.time_s.front() >= needed_s)
        paths_.push_back(resampled(piece, step_s));
  }

  [[nodiscard]] bool goalsMove() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double squares = 0.0, count = 0.0;
    for (const auto& path : paths_)
      for (const auto& point : path.goal) {
        sum += point;
        squares += point.squaredNorm();
        count += 1.0;
      }
    if (count == 0.0) return false;
    return squares / count - (sum / count).squaredNorm() > kLeastMovement_m * kLeastMovement_m;
  }

  /// Best shift in steps, with its fraction.
  [[nodiscard]] std::optional<double> best() const {
    std::vector<double> costs;
    for (int shift = least_; shift <= largest_; ++shift) costs.push_back(cost(shift));
    const auto best = std::ranges::min_element(costs);
    if (best == costs.begin() || best == costs.end() - 1) return std::nullopt;
    const double before = *(best - 1), behind = *(best + 1), bend = before - 2.0 * *best + behind;
    const double fraction = bend > 0.0 ? 0.5 * (before - behind) / bend : 0.0;
    return least_ + static_cast<double>(best - costs.begin()) + fraction;
  }

 private:
  [[nodiscard]] double cost(int shift) const {
    double sum = 0.0;
    for (const auto& path : paths_)
      for (int i = largest_; i < static_cast<int>(path.goal.size()) + least_; ++i)
        sum += (path.reached[static_cast<std::size_t>(i)] - path.goal[static_cast<std::size_t>(i - shift)])
                   .squaredNorm();
    return sum;
  }

  int least_, largest_;
  std::vector<EvenPaths> paths_;
};

}  // namespace

Eigen::Vector3d pointAt(std::span<const double> time_s, std::span<const Eigen::Vector3d> path, double time) {
  const auto after = std::ranges::upper_bound(time_s, time) - time_s.begin();
  if (after == 0) return path.front();
  if (after == std::ssize(time_s)) return path.back();
  const auto i = static_cast<std::size_t>(after);
  const double share = (time - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
  return path[i - 1] + share * (path[i] - path[i - 1]);
}

std::optional<double> lagOf(std::span<const PathPair> pieces) {
  const double step_s = medianInterval(pieces);
  if (!(step_s >= kLeastStep_s)) return std::nullopt;
  const ShiftSearch search(pieces, step_s);
  if (!search.goalsMove()) return std::nullopt;
  const auto shift = search.best();
  if (!shift) return std::nullopt;
  return *shift * step_s;
}

}  // namespace mirrorarm::therapy
