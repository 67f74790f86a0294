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
constexpr std::size_t kNearest = 8;        // discs around a seed that may be its neighbours
constexpr std::size_t kMostBases = 4;      // tried a seed
constexpr double kMostCosine = 0.35;       // between the steps to two neighbours, on the board
constexpr double kMostStepRatio = 1.35;    // of their lengths
constexpr double kNear = 0.3;              // of a step, as far as a neighbour may be from its guess
constexpr double kMostAreaRatio = 12.0;    // of neighbouring discs
constexpr double kMostStraying = 0.04;     // of a step, from where the surroundings say
constexpr double kLeastStraying_px = 0.5;  // that is let pass

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

struct Node {
  std::size_t disc = 0;
  Eigen::Matrix2d steps_px;
};

/// Grows one lattice from neighbour to neighbour.
class Growth {
 public:
  Growth(const Discs& discs, std::size_t seed, const Eigen::Matrix2d& steps_px)
      : discs_(discs), is_used_(discs.size(), false) {
    put(Place::Zero(), seed, steps_px);
    while (!open_.empty()) {
      const Place place = open_.front();
      open_.pop();
      for (const Place& step : {Place(1, 0), Place(0, 1), Place(-1, 0), Place(0, -1)}) extend(place, step);
    }
  }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const auto& nodes() const { return nodes_; }

 private:
  using Key = std::pair<int, int>;
  static Key key(const Place& place) { return {place.y(), place.x()}; }

  void put(const Place& place, std::size_t disc, const Eigen::Matrix2d& steps_px) {
    nodes_[key(place)] = {disc, steps_px};
    is_used_[disc] = true;
    open_.push(place);
  }

  /// The step onwards as the one before was, or as it was handed on.
  [[nodiscard]] Eigen::Vector2d stepFrom(const Place& place, const Place& step, const Node& node) const {
    const auto before = nodes_.find(key(place - step));
    if (before != nodes_.end()) return discs_.pixel(node.disc) - discs_.pixel(before->second.disc);
    return node.steps_px * step.cast<double>();
  }

  void extend(const Place& place, const Place& step) {
    if (nodes_.contains(key(place + step))) return;
    const Node node = nodes_.at(key(place));
    const Eigen::Vector2d onwards_px = stepFrom(place, step, node);
    const auto next = neighbourAt(node, discs_.pixel(node.disc) + onwards_px);
    if (!next) return;
    Eigen::Matrix2d steps_px = node.steps_px;
    steps_px.col(step.x() != 0 ? 0 : 1) =
        (step.x() + step.y()) * (discs_.pixel(*next) - discs_.pixel(node.disc));
    put(place + step, *next, steps_px);
  }

  [[nodiscard]] std::optional<std::size_t> neighbourAt(const Node& from, const Eigen::Vector2d& guess) const {
    const Eigen::Matrix2d to_steps = from.steps_px.inverse();
    const double area = discs_.shape(from.disc).determinant();
    std::optional<std::size_t> found;
    double nearest = kNear;
    const double reach_px = kNear * (from.steps_px.col(0).norm() + from.steps_px.col(1).norm());
    discs_.near(guess, reach_px, [&](std::size_t disc) {
      const double off = (to_steps * (discs_.pixel(disc) - guess)).norm();
      const double ratio = std::sqrt(discs_.shape(disc).determinant() / area);
      if (is_used_[disc] || !(off < nearest) || ratio > kMostAreaRatio || ratio < 1.0 / kMostAreaRatio)
        return;
      nearest = off;
      found = disc;
    });
    return found;
  }

  const Discs& discs_;
  std::map<Key, Node> nodes_;
  std::vector<bool> is_used_;
  std::queue<Place> open_;
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

std::map<std::pair<int, int>, Node> grown(const Discs& discs) {
  std::map<std::pair<int, int>, Node> best;
  std::vector<bool> is_tried(discs.size(), false);
  std::size_t left = discs.size();
  for (std::size_t seed = 0; seed < discs.size() && left > best.size(); ++seed) {
    if (is_tried[seed]) continue;
    std::map<std::pair<int, int>, Node> here;
    for (const auto& basis : basesAt(discs, seed)) {
      const Growth growth(discs, seed, basis);
      if (growth.size() > here.size()) here = growth.nodes();
    }
    for (const auto& [place, node] : here) {
      if (!is_tried[node.disc]) --left;
      is_tried[node.disc] = true;
    }
    if (!is_tried[seed]) --left;
    is_tried[seed] = true;
    if (here.size() > best.size()) best = std::move(here);
  }
  return best;
}

/// How far a disc lies from where its surroundings say, against what is let pass; nothing said is too far.
double strayingOf(const PlacedDisc& placed, const GridPixels& pixels, PlacedDisc& mapped) {
  mapped = placed;
  const auto map = pixels.around(placed.place);
  if (!map) return std::numeric_limits<double>::infinity();
  mapped.steps_px = map->steps_px;
  const double step_px = std::sqrt(std::abs(map->steps_px.determinant()));
  const double off_px = (pixels.at(placed.place).value() - map->pixel).norm();
  return off_px / std::max(kMostStraying * step_px, kLeastStraying_px);
}

/// Drops the disc that strays most, one after the other: it pulls at what its neighbours expect.
std::vector<PlacedDisc> withoutStrays(std::vector<PlacedDisc> lattice, GridPixels pixels) {
  while (!lattice.empty()) {
    std::size_t worst = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      PlacedDisc mapped;
      const double straying = strayingOf(lattice[i], pixels, mapped);
      lattice[i] = mapped;
      if (straying <= most) continue;
      most = straying;
      worst = i;
    }
    if (most <= 1.0) break;
    pixels.erase(lattice[worst].place);
    lattice.erase(lattice.begin() + static_cast<std::ptrdiff_t>(worst));
  }
  return lattice;
}

}  // namespace

std::vector<PlacedDisc> largestLattice(std::span<const SeenPoint> discs) {
  const auto nodes = grown(Discs(discs));
  if (nodes.size() < kFewest) return {};
  std::vector<PlacedDisc> lattice;
  GridPixels pixels;
  for (const auto& [at, node] : nodes) {
    const Place place(at.second, at.first);
    lattice.push_back({place, node.disc, node.steps_px});
    pixels.set(place, discs[node.disc].pixel);
  }
  lattice = withoutStrays(std::move(lattice), std::move(pixels));
  if (lattice.size() < kFewest) lattice.clear();
  return lattice;
}

}  // namespace mirrorarm::calibration
