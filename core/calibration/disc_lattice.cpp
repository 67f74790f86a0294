#include "core/calibration/disc_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <queue>

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewest = 6;
constexpr std::size_t kNearest = 8;      // discs around a seed that may be its neighbours
constexpr std::size_t kMostBases = 4;    // tried a seed
constexpr double kMostCosine = 0.35;     // between the steps to two neighbours, on the board
constexpr double kMostStepRatio = 1.35;  // of their lengths
constexpr double kFirstNear = 0.3;       // of a step, as far as a neighbour may be from where one is expected
constexpr double kNear = 0.15;           // the same where more neighbours are known
constexpr double kLeastCell_px2 = 9.0;
constexpr double kLeastStraying_px = 0.25;  // that is let pass

/// The discs of an image, sorted for looking them up by place.
class Discs {
 public:
  explicit Discs(std::span<const SeenPoint> discs) : discs_(discs) {
    for (std::size_t i = 0; i < discs.size(); ++i) by_x_.push_back({discs[i].pixel.x(), i});
    std::sort(by_x_.begin(), by_x_.end());
  }
  [[nodiscard]] std::size_t size() const { return discs_.size(); }
  [[nodiscard]] const Eigen::Vector2d& pixel(std::size_t disc) const { return discs_[disc].pixel; }
  [[nodiscard]] const Eigen::Matrix2d& shape(std::size_t disc) const { return discs_[disc].shape_px2; }

  /// Calls `visit` with every disc up to `reach_px` to the left or right.
  template <class Visit>
  void near(const Eigen::Vector2d& pixel, double reach_px, Visit visit) const {
    const std::pair<double, std::size_t> left{pixel.x() - reach_px, 0};
    for (auto at = std::lower_bound(by_x_.begin(), by_x_.end(), left);
         at != by_x_.end() && at->first <= pixel.x() + reach_px; ++at)
      visit(at->second);
  }

 private:
  std::span<const SeenPoint> discs_;
  std::vector<std::pair<double, std::size_t>> by_x_;
};

using Key = std::pair<int, int>;
Key key(const Place& place) { return {place.y(), place.x()}; }

struct Node {
  std::size_t disc = 0;
  Eigen::Matrix2d steps_px;
};
using Nodes = std::map<Key, Node>;

constexpr std::array<std::pair<int, int>, 4> kSides = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// A disc that may lie at a place, by how far it is from where it is expected, in steps.
struct Candidate {
  double off = 0.0;
  Place place = Place::Zero();
  Node node;
  std::size_t judged_at = 0;  ///< size of the lattice by then

  bool operator<(const Candidate& other) const { return off > other.off; }  // the nearest comes first
};

/// Grows one lattice from neighbour to neighbour, the surest first: so a light between the dots finds its
/// place taken, or expected elsewhere.
class Growth {
 public:
  Growth(const Discs& discs, const LatticeLimits& limits, std::size_t seed, const Eigen::Matrix2d& steps_px)
      : discs_(discs), limits_(limits), is_used_(discs.size(), false) {
    put(Place::Zero(), {seed, steps_px});
    while (!open_.empty()) {
      const Candidate next = open_.top();
      open_.pop();
      if (nodes_.contains(key(next.place))) continue;
      if (next.judged_at == nodes_.size())
        put(next.place, next.node);
      else
        judge(next.place);
    }
  }
  [[nodiscard]] const Nodes& nodes() const { return nodes_; }

 private:
  void put(const Place& place, const Node& node) {
    nodes_[key(place)] = node;
    pixels_.set(place, discs_.pixel(node.disc));
    is_used_[node.disc] = true;
    for (const auto& [x, y] : kSides)
      if (!nodes_.contains(key(place + Place(x, y)))) judge(place + Place(x, y));
  }

  void judge(const Place& place) {
    const auto expected = pixels_.around(place);
    const LocalMap map = expected ? *expected : besideAt(place);
    auto candidate = nearestTo(map, expected ? kNear : kFirstNear);
    if (!candidate) return;
    candidate->place = place;
    candidate->judged_at = nodes_.size();
    open_.push(*candidate);
  }

  /// From one neighbour on, by the step before or as its steps were handed on: how a lattice begins.
  [[nodiscard]] LocalMap besideAt(const Place& place) const {
    for (const auto& [x, y] : kSides) {
      const Place step(x, y);
      const auto from = nodes_.find(key(place - step));
      if (from == nodes_.end()) continue;
      LocalMap map{discs_.pixel(from->second.disc), from->second.steps_px};
      if (const auto before = pixels_.at(place - 2 * step))
        map.steps_px.col(x != 0 ? 0 : 1) = (x + y) * (map.pixel - *before);
      map.pixel += map.steps_px * step.cast<double>();
      return map;
    }
    return {};
  }

  [[nodiscard]] std::optional<Candidate> nearestTo(const LocalMap& map, double reach) const {
    const double area_px2 = std::abs(map.steps_px.determinant());
    if (!(area_px2 > kLeastCell_px2)) return std::nullopt;
    const Eigen::Matrix2d to_steps = map.steps_px.inverse();
    std::optional<Candidate> found;
    const double reach_px = reach * (map.steps_px.col(0).norm() + map.steps_px.col(1).norm());
    discs_.near(map.pixel, reach_px, [&](std::size_t disc) {
      const double off = (to_steps * (discs_.pixel(disc) - map.pixel)).norm();
      if (is_used_[disc] || !(off < reach) || !limits_.holds(diameterOf(discs_.shape(disc), map.steps_px)))
        return;
      reach = off;
      found = Candidate{off, {}, {disc, map.steps_px}, 0};
    });
    return found;
  }

  const Discs& discs_;
  LatticeLimits limits_;
  Nodes nodes_;
  GridPixels pixels_;
  std::vector<bool> is_used_;
  std::priority_queue<Candidate> open_;
};

struct Step {
  Eigen::Vector2d step_px;
  Eigen::Vector2d on_board;  ///< in radii of the seed's disc
};

/// Steps to the discs that are nearest on the board.
std::vector<Step> stepsAround(const Discs& discs, std::size_t seed) {
  const Eigen::Matrix2d to_board =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(discs.shape(seed)).operatorInverseSqrt();
  std::vector<Step> steps;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (i == seed) continue;
    const Eigen::Vector2d step_px = discs.pixel(i) - discs.pixel(seed);
    steps.push_back({step_px, to_board * step_px});
  }
  const auto count = std::min(kNearest, steps.size());
  std::partial_sort(
      steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(count), steps.end(),
      [](const Step& a, const Step& b) { return a.on_board.squaredNorm() < b.on_board.squaredNorm(); });
  steps.resize(count);
  return steps;
}

/// Pairs of steps that are square on the board, shortest first.
std::vector<Eigen::Matrix2d> basesAt(const Discs& discs, std::size_t seed) {
  const auto steps = stepsAround(discs, seed);
  std::vector<Eigen::Matrix2d> bases;
  for (std::size_t j = 1; j < steps.size() && bases.size() < kMostBases; ++j)
    for (std::size_t i = 0; i < j && bases.size() < kMostBases; ++i) {
      const Step &a = steps[i], &b = steps[j];
      const double shorter = a.on_board.norm(), longer = b.on_board.norm();
      if (longer > kMostStepRatio * shorter) continue;
      if (std::abs(a.on_board.dot(b.on_board)) > kMostCosine * shorter * longer) continue;
      Eigen::Matrix2d basis;
      basis << a.step_px, b.step_px;
      if (basis.determinant() < 0.0) basis.col(0).swap(basis.col(1));
      bases.push_back(basis);
    }
  return bases;
}

bool isSurrounded(const Place& place, const GridPixels& pixels) {
  return std::all_of(kSides.begin(), kSides.end(),
                     [&](const auto& side) { return pixels.at(place + Place(side.first, side.second)); });
}

/// A lattice without the discs that stray: the worst goes first, as it pulls at what its neighbours expect.
class Pruning {
 public:
  Pruning(const Discs& discs, const LatticeLimits& limits, const Nodes& nodes) : limits_(limits) {
    for (const auto& [at, node] : nodes) {
      const Place place(at.second, at.first);
      pixels_.set(place, discs.pixel(node.disc));
      judged_.push_back({{place, node.disc, node.steps_px}, 0.0});
    }
    for (auto& one : judged_) judge(one);
  }

  [[nodiscard]] std::vector<PlacedDisc> pruned() {
    while (!judged_.empty()) {
      const auto worst =
          std::max_element(judged_.begin(), judged_.end(),
                           [](const Judged& a, const Judged& b) { return a.straying < b.straying; });
      if (worst->straying <= 1.0) break;
      const Place gone = worst->placed.place;
      pixels_.erase(gone);
      judged_.erase(worst);
      for (auto& one : judged_)
        if ((one.placed.place - gone).cwiseAbs().maxCoeff() <= GridPixels::kReach) judge(one);
    }
    std::vector<PlacedDisc> lattice;
    for (const auto& one : judged_) lattice.push_back(one.placed);
    return lattice;
  }

 private:
  struct Judged {
    PlacedDisc placed;
    double straying = 0.0;  ///< against what is let pass
  };

  /// Where the surroundings say nothing, a disc strays.
  void judge(Judged& one) const {
    one.straying = std::numeric_limits<double>::infinity();
    const auto map = pixels_.around(one.placed.place);
    if (!map) return;
    one.placed.steps_px = map->steps_px;
    const double step_px = std::sqrt(std::abs(map->steps_px.determinant()));
    const double most = isSurrounded(one.placed.place, pixels_) ? limits_.most_inside : limits_.most_at_rim;
    one.straying = (pixels_.at(one.placed.place).value() - map->pixel).norm() /
                   std::max(most * step_px, kLeastStraying_px);
  }

  LatticeLimits limits_;
  GridPixels pixels_;
  std::vector<Judged> judged_;
};

}  // namespace

double diameterOf(const Eigen::Matrix2d& shape_px2, const Eigen::Matrix2d& steps_px) {
  return 2.0 * std::sqrt(std::sqrt(shape_px2.determinant()) / std::abs(steps_px.determinant()));
}

std::vector<PlacedDisc> largestLattice(std::span<const SeenPoint> seen, const LatticeLimits& limits) {
  const Discs discs(seen);
  std::vector<PlacedDisc> best;
  std::vector<bool> is_tried(discs.size(), false);  // discs of one lattice are no seeds any more
  std::size_t left = discs.size();
  for (std::size_t seed = 0; seed < discs.size() && left > best.size(); ++seed) {
    if (is_tried[seed]) continue;
    for (const auto& basis : basesAt(discs, seed)) {
      const Growth growth(discs, limits, seed, basis);
      if (growth.nodes().size() <= best.size()) continue;
      auto lattice = Pruning(discs, limits, growth.nodes()).pruned();
      for (const auto& placed : lattice) is_tried[placed.disc] = true;
      if (lattice.size() > best.size()) best = std::move(lattice);
      if (2 * best.size() > discs.size()) break;
    }
    is_tried[seed] = true;
    left = static_cast<std::size_t>(std::count(is_tried.begin(), is_tried.end(), false));
  }
  if (best.size() < kFewest) best.clear();
  return best;
}

}  // namespace mirrorarm::calibration
