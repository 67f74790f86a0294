#include "core/tracking/match_matrix.h"

#include <cassert>

namespace mirrorarm::tracking {
namespace {

constexpr int kMaxRounds = 100;
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
  normaliseRowLogarithms();
  normaliseColumnLogarithms();
  balance();
}

// In a hard matrix a pair's two factors share its entry evenly; from any other start the slacks would follow
// only as 1/n. Later the logarithms of the factors grow in step with beta.
void MatchMatrix::startColumns(double beta) {
  if (beta_ > 0.0) {
    log_column_ *= beta / beta_;
  } else {
    log_column_ = -0.5 * log_entries_.colwise().maxCoeff().max(0.0);
  }
  beta_ = beta;
}

// Factor of a row: one over the sum of its entries and its slack 1, the largest taken out before exp().
void MatchMatrix::normaliseRowLogarithms() {
  terms_ = log_entries_.rowwise() + log_column_;
  row_peak_ = terms_.rowwise().maxCoeff().max(0.0);
  terms_.colwise() -= row_peak_;
  terms_ = terms_.exp();
  log_row_ = -row_peak_ - (terms_.rowwise().sum() + (-row_peak_).exp()).log();
}

void MatchMatrix::normaliseColumnLogarithms() {
  terms_ = log_entries_.colwise() + log_row_;
  column_peak_ = terms_.colwise().maxCoeff().max(0.0);
  terms_.rowwise() -= column_peak_;
  terms_ = terms_.exp();
  log_column_ = -column_peak_ - (terms_.colwise().sum() + (-column_peak_).exp()).log();
}

// After one round on logarithms every sum lies near 1, so the further rounds need no exp().
void MatchMatrix::balance() {
  weights_.array() = ((log_entries_.colwise() + log_row_).rowwise() + log_column_).exp();
  row_slack_ = log_row_.exp();
  column_slack_ = log_column_.exp();
  row_factor_.setOnes(weights_.rows());
  column_factor_.setOnes(weights_.cols());
  for (int round = 0; round < kMaxRounds; ++round) {
    row_factor_before_ = row_factor_;
    row_factor_.noalias() = weights_ * column_factor_.transpose();
    row_factor_.array() = (row_slack_ + row_factor_.array()).inverse();
    column_factor_.noalias() = row_factor_.transpose() * weights_;
    column_factor_.array() = (column_slack_ + column_factor_.array()).inverse();
    if ((row_factor_ - row_factor_before_).lpNorm<Eigen::Infinity>() < kAgreement) break;
  }
  weights_.array() = (weights_.array().colwise() * row_factor_.array()).rowwise() * column_factor_.array();
  slack_ = row_slack_ * row_factor_.array();
  slack_row_ = column_slack_ * column_factor_.array();
  log_row_ += row_factor_.array().log();
  log_column_ += column_factor_.array().log();
}

bool MatchMatrix::isBinary(double tolerance) const {
  const auto undecided = [tolerance](const auto& shares) {
    return (shares > tolerance && shares < 1.0 - tolerance).any();
  };
  return !undecided(weights_.array()) && !undecided(slack_) && !undecided(slack_row_);
}

}  // namespace mirrorarm::tracking
