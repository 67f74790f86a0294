#include "core/tracking/match_matrix.h"

#include <cassert>

namespace mirrorarm::tracking {
namespace {

constexpr int kMaxRounds = 30;
constexpr double kAgreement = 1e-4;

}  // namespace

void MatchMatrix::reset(Eigen::Index rows, Eigen::Index columns) {
  beta_ = 0.0;
  log_entries_.resize(rows, columns);
  weights_.setZero(rows, columns);
  log_row_.setZero(rows);
  slack_.setOnes(rows);
  log_column_.setZero(columns);
  slack_row_.setOnes(columns);
}

void MatchMatrix::assign(const Eigen::ArrayXXd& Q_mm2, double beta) {
  assert(Q_mm2.rows() == log_entries_.rows() && Q_mm2.cols() == log_entries_.cols());
  log_entries_ = -beta * Q_mm2;
  startColumns(beta);
  for (int round = 0; round < kMaxRounds; ++round) {
    log_row_before_ = log_row_;
    normaliseRows();
    normaliseColumns();
    if (round > 0 && (log_row_ - log_row_before_).abs().maxCoeff() < kAgreement) break;
  }
  weights_ = ((log_entries_.colwise() + log_row_).rowwise() + log_column_).exp();
  slack_ = log_row_.exp();
  slack_row_ = log_column_.exp();
}

// In a hard matrix a pair's two factors share its entry evenly; from any other start the slacks would follow only
// as 1/n. Later the logarithms of the factors grow in step with beta.
void MatchMatrix::startColumns(double beta) {
  if (beta_ > 0.0) {
    log_column_ *= beta / beta_;
  } else {
    log_column_ = -0.5 * log_entries_.colwise().maxCoeff().max(0.0);
  }
  beta_ = beta;
}

// Factor of a row: one over the sum of its entries and its slack 1, the largest taken out before exp().
void MatchMatrix::normaliseRows() {
  weights_ = log_entries_.rowwise() + log_column_;
  row_peak_ = weights_.rowwise().maxCoeff().max(0.0);
  weights_.colwise() -= row_peak_;
  weights_ = weights_.exp();
  log_row_ = -row_peak_ - (weights_.rowwise().sum() + (-row_peak_).exp()).log();
}

void MatchMatrix::normaliseColumns() {
  weights_ = log_entries_.colwise() + log_row_;
  column_peak_ = weights_.colwise().maxCoeff().max(0.0);
  weights_.rowwise() -= column_peak_;
  weights_ = weights_.exp();
  log_column_ = -column_peak_ - (weights_.colwise().sum() + (-column_peak_).exp()).log();
}

bool MatchMatrix::isBinary(double tolerance) const {
  const auto undecided = [tolerance](const auto& shares) {
    return (shares > tolerance && shares < 1.0 - tolerance).any();
  };
  return !undecided(weights_) && !undecided(slack_) && !undecided(slack_row_);
}

}  // namespace mirrorarm::tracking
