#pragma once

#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/network_term.h"

namespace mirrorarm::tracking {

/// One marker as one frame saw it.
struct Sighting {
  int marker = 0;
  Eigen::Vector3d point_C = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();  ///< of the sensor, in C; zero when not known
};

/// What one frame saw, each marker at most once, and where the body was.
struct NetworkFrame {
  RigidTransform X_CT = RigidTransform::Identity();
  std::vector<Sighting> sightings;
};

/// Markers on one body and the frames that saw them: unknown are all of markers_T, X_CT and spread_m.
struct MarkerNetwork {
  std::vector<Eigen::Vector3d> markers_T;
  /// One a marker: its standard deviation per axis beyond what the sensor explains [m]; negative: not known.
  std::vector<double> spread_m;
  std::vector<NetworkFrame> frames;
};

/// Adjusts a network of markers and poses to the greatest likelihood (bundle adjustment over points).
///
/// Each sighting weighs by its sensor's covariance and its marker's own spread, which is estimated with the
/// rest: markers on skin count less and come out less sure, and where the sensor's covariance is unknown the
/// spread stands for it. Huber's weights, none for gross outliers. Poses are eliminated (Schur complement).
/// Nothing ties the markers to a frame: the gauge is free, held by inner constraints (no common shift or turn
/// of the markers against where they started), so that the covariance is that of the shape alone and has the
/// least trace. Frames with fewer than 3 sightings tell nothing about the shape and stay as they are.
///
/// Source: Triggs et al., Bundle Adjustment - A Modern Synthesis, 1999, sections 6 and 9; inner constraints:
/// Granshaw, Photogrammetric Record 10(56), 1980; spreads by restricted maximum likelihood: Patterson and
/// Thompson, Biometrika 58, 1971. Keeps its buffers; one thread.
class BundleAdjustment {
 public:
  /// Starts from the network as it is, poses right to a few millimetres and degrees. At least 3 markers not
  /// on a line, each sighted. Ends when nothing moves by more than a nanometre, or after `max_steps`.
  void adjust(MarkerNetwork& network, int max_steps = 20);

  /// Of all markers' coordinates in their order [m^2]; singular in the 6 motions that the network leaves
  /// free. Spreads that last from frame to frame average out slowly; that is accounted for.
  [[nodiscard]] const Eigen::MatrixXd& covariance_m2() const { return covariance_m2_; }
  /// The block of one marker.
  [[nodiscard]] Eigen::Matrix3d covarianceOf(std::size_t marker) const;
  /// Sum of the squared residuals in units of their covariance, outliers left out.
  [[nodiscard]] double chi2() const;
  /// Coordinates measured less numbers solved for.
  [[nodiscard]] int freedom() const;

 private:
  void linearise(const MarkerNetwork& network);
  void linearise(const MarkerNetwork& network, std::size_t frame);
  void reduce(std::span<NetworkTerm> terms);
  void factorise(const MarkerNetwork& network);
  double move(MarkerNetwork& network);
  void moveFrame(RigidTransform& X_CT, std::span<NetworkTerm> terms) const;
  void findCovariance(const MarkerNetwork& network);

  std::vector<NetworkTerm> terms_;       ///< frame by frame
  std::vector<std::size_t> first_term_;  ///< of each frame, and one past the last
  std::vector<double> sigmas_;           ///< of one frame's sightings
  SpreadEstimator spreads_;
  Eigen::MatrixXd normal_;  ///< lower half
  Eigen::MatrixXd free_;    ///< orthonormal motions that no sighting tells
  Eigen::LLT<Eigen::MatrixXd> factors_;
  Eigen::MatrixXd covariance_m2_;
  Eigen::VectorXd gradient_, step_;
  double free_weight_ = 0.0;
  int frames_used_ = 0;
};

}  // namespace mirrorarm::tracking
