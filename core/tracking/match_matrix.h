#pragma once

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// The doubly stochastic match matrix with slack row and column (paper, equations 18, 19, 23 and 24): entry
/// (j, k) is how likely model point j is cloud point k, the slacks how likely a point has no partner.
/// Everything is kept as logarithms of the row and column factors, so no beta overflows. Factors are carried
/// on from call to call: annealing starts each normalisation close to its end. Keeps its buffers.
class MatchMatrix {
 public:
  /// Starts anew for `rows` model and `columns` cloud points.
  void reset(Eigen::Index rows, Eigen::Index columns);

  /// Entries exp(-beta * Q), slacks 1, then rows and columns normalised in turn until they agree.
  /// `Q_mm2` has the size given to reset().
  void assign(const Eigen::ArrayXXd& Q_mm2, double beta);

  /// The entries without the slacks.
  [[nodiscard]] const Eigen::MatrixXd& weights() const { return weights_; }
  /// For each model point the share that has no partner.
  [[nodiscard]] const Eigen::ArrayXd& slack() const { return slack_; }
  /// True when each entry and slack is 0 or 1 to `tolerance`: a larger beta changes nothing any more.
  [[nodiscard]] bool isBinary(double tolerance) const;

 private:
  void startColumns(double beta);
  void normaliseRowLogarithms();
  void normaliseColumnLogarithms();
  void balance();

  double beta_ = 0.0;
  using RowArray = Eigen::Array<double, 1, Eigen::Dynamic>;
  Eigen::ArrayXXd log_entries_, terms_;
  Eigen::MatrixXd weights_;
  Eigen::ArrayXd log_row_, row_peak_, row_slack_, slack_;
  RowArray log_column_, column_peak_, column_slack_, slack_row_;
  Eigen::VectorXd row_factor_, row_factor_before_;
  Eigen::RowVectorXd column_factor_;
};

}  // namespace mirrorarm::tracking
