#include "plate_lattice.h"

#include <limits>

#include <Eigen/Dense>
#include <queue>

namespace mirrorarm::vision {
namespace {

constexpr double kNear = 0.3;  // of a step: as far as a neighbour may be from where it is expected

}  // namespace

PlateLattice::PlateLattice(const std::vector<Eigen::Vector2d>& dots) : dots_(dots), places_(dots.size()) {
  if (dots_.size() < 3) return;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& dot : dots_) middle += dot / static_cast<double>(dots_.size());
  grow(*nearest(middle, std::numeric_limits<double>::max()));
  Place low(std::numeric_limits<int>::max(), std::numeric_limits<int>::max()), high = -low;
  for (const auto& place : places_) {
    if (!place) continue;
    low = low.cwiseMin(*place);
    high = high.cwiseMax(*place);
  }
  size_ = high - low + Place::Ones();
  for (auto& place : places_)
    if (place) *place -= low;
}

std::optional<std::size_t> PlateLattice::nearest(const Eigen::Vector2d& to, double within) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    const double distance = (dots_[i] - to).norm();
    if (distance >= within) continue;
    within = distance;
    found = i;
  }
  return found;
}

/// The nearest neighbour, and the nearest one across; the column's step is the one along x.
PlateLattice::Basis PlateLattice::basisAt(std::size_t dot) const {
  Eigen::Vector2d first = Eigen::Vector2d::Constant(1e9), second = first;
  for (std::size_t i = 0; i < dots_.size(); ++i)
    if (i != dot && (dots_[i] - dots_[dot]).norm() < first.norm()) first = dots_[i] - dots_[dot];
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    const Eigen::Vector2d step = dots_[i] - dots_[dot];
    const bool across = std::abs(step.dot(first)) < 0.5 * step.norm() * first.norm();
    if (i != dot && across && step.norm() < second.norm()) second = step;
  }
  if (std::abs(first.x()) < std::abs(second.x())) std::swap(first, second);
  return {{first.x() < 0.0 ? Eigen::Vector2d(-first) : first,
           second.y() < 0.0 ? Eigen::Vector2d(-second) : second}};
}

void PlateLattice::grow(std::size_t start) {
  std::queue<std::pair<std::size_t, Basis>> open;
  places_[start] = Place::Zero();
  open.push({start, basisAt(start)});
  while (!open.empty()) {
    const auto [dot, basis] = open.front();
    open.pop();
    for (const int axis : {0, 1})
      for (const int sign : {-1, 1}) {
        const Eigen::Vector2d step = sign * basis.step[static_cast<std::size_t>(axis)];
        const auto next = nearest(dots_[dot] + step, kNear * step.norm());
        if (!next || places_[*next]) continue;
        places_[*next] = *places_[dot] + sign * Place::Unit(axis);
        Basis there = basis;
        there.step[static_cast<std::size_t>(axis)] = sign * (dots_[*next] - dots_[dot]);
        open.push({*next, there});
      }
  }
}

Eigen::Matrix3d homographyOf(const std::vector<Place>& places, const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean += point / static_cast<double>(points.size());
  double spread = 0.0;
  for (const auto& point : points) spread += (point - mean).norm() / static_cast<double>(points.size());
  Eigen::MatrixXd A(2 * static_cast<Eigen::Index>(points.size()), 9);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = (points[i] - mean) / spread;
    const Eigen::RowVector3d q = places[i].cast<double>().homogeneous().transpose() / 10.0;
    const auto row = 2 * static_cast<Eigen::Index>(i);
    A.row(row) << q, Eigen::RowVector3d::Zero(), -p.x() * q;
    A.row(row + 1) << Eigen::RowVector3d::Zero(), q, -p.y() * q;
  }
  const Eigen::VectorXd h = A.jacobiSvd(Eigen::ComputeThinV).matrixV().col(8);
  Eigen::Matrix3d H;
  H << h.segment<3>(0).transpose(), h.segment<3>(3).transpose(), h.segment<3>(6).transpose();
  Eigen::Matrix3d back;
  back << spread, 0, mean.x(), 0, spread, mean.y(), 0, 0, 1;
  return back * H;
}

}  // namespace mirrorarm::vision
