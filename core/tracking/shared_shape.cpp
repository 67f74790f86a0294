#include "core/tracking/shared_shape.h"

#include <cmath>

#include "core/geometry/rigid_fit.h"
#include "core/tracking/layout.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;
using Points = std::span<const Vector3d>;

constexpr int kMaxSteps = 300'000;
constexpr double kHopelessInRms = 3.0;  // a part that fits so much worse than the whole may does not help

/// Depth-first search for the largest set of pairs whose distances agree.
class Search {
 public:
  /// `apart_m` below 0: any pose counts.
  Search(Points x, Points y, const Likeness& likeness, double apart_m)
      : x_(x), y_(y), likeness_(likeness), apart_m_(apart_m), y_of_x_(x.size(), -1), taken_(y.size(), 0) {
    best_.y_of_x.assign(x.size(), -1);
  }

  SharedShape run() {
    extend(0);
    return best_;
  }

 private:
  void extend(std::size_t from) {
    for (std::size_t i = from; i < x_.size() && ++steps_ < kMaxSteps; ++i) {
      const std::size_t most = x_part_.size() + x_.size() - i;
      if (most < static_cast<std::size_t>(std::max(likeness_.least_markers, best_.markers))) return;
      for (std::size_t k = 0; k < y_.size(); ++k)
        if (taken_[k] == 0 && agrees(x_[i], y_[k])) tryPair(i, k);
    }
  }

  [[nodiscard]] bool agrees(const Vector3d& x, const Vector3d& y) const {
    for (std::size_t p = 0; p < x_part_.size(); ++p)
      if (std::abs((x - x_part_[p]).norm() - (y - y_part_[p]).norm()) > likeness_.distance_tolerance_m)
        return false;
    return true;
  }

  void tryPair(std::size_t i, std::size_t k) {
    y_of_x_[i] = static_cast<int>(k);
    taken_[k] = 1;
    x_part_.push_back(x_[i]);
    y_part_.push_back(y_[k]);
    if (x_part_.size() < 3 || judge()) extend(i + 1);
    x_part_.pop_back();
    y_part_.pop_back();
    taken_[k] = 0;
    y_of_x_[i] = -1;
  }

  /// Keeps what is better than the best; false when more pairs cannot help.
  bool judge() {
    const RigidTransform X_YX = fitByKabsch(x_part_, y_part_);
    const double rms_m = fitRms(X_YX, x_part_, y_part_);
    if (rms_m > kHopelessInRms * likeness_.max_rms_m) return false;
    if (areCollinear(x_part_)) return true;
    if (isOwnPose(X_YX)) return false;
    const auto markers = static_cast<int>(x_part_.size());
    const bool better = markers > best_.markers || (markers == best_.markers && rms_m < best_.rms_m);
    if (better && markers >= likeness_.least_markers && rms_m <= likeness_.max_rms_m)
      best_ = {X_YX, y_of_x_, markers, rms_m};
    return true;
  }

  [[nodiscard]] bool isOwnPose(const RigidTransform& X_YX) const {
    if (apart_m_ < 0.0) return false;
    for (const auto& p : x_)
      if ((X_YX * p - p).norm() > apart_m_) return false;
    return true;
  }

  Points x_, y_;
  const Likeness& likeness_;
  double apart_m_;
  std::vector<int> y_of_x_;
  std::vector<char> taken_;
  std::vector<Vector3d> x_part_, y_part_;
  SharedShape best_;
  int steps_ = 0;
};

}  // namespace

SharedShape findSharedShape(Points x, Points y, const Likeness& likeness) {
  return Search(x, y, likeness, -1.0).run();
}

SharedShape findSelfLikeness(Points x, const Likeness& likeness, double apart_m) {
  return Search(x, x, likeness, apart_m).run();
}

}  // namespace mirrorarm::tracking
