#include "core/calibration/visp_bridge.h"

#include <iostream>
#include <streambuf>

#include <visp3/vision/vpHandEyeCalibration.h>

namespace mirrorarm::calibration {
namespace {

/// Takes what is written and forgets it.
class Nowhere final : public std::streambuf {
 protected:
  int_type overflow(int_type character) override { return traits_type::not_eof(character); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

class SilentOutput {
 public:
  SilentOutput() : kept_(std::cout.rdbuf(&nowhere_)) {}
  ~SilentOutput() { std::cout.rdbuf(kept_); }
  SilentOutput(const SilentOutput&) = delete;
  SilentOutput& operator=(const SilentOutput&) = delete;

 private:
  Nowhere nowhere_;
  std::streambuf* kept_;
};

vpHomogeneousMatrix toVisp(const Eigen::Isometry3d& X) {
  vpHomogeneousMatrix M;
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 4; ++column) M[row][column] = X.matrix()(row, column);
  return M;
}

std::vector<vpHomogeneousMatrix> toVisp(const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<vpHomogeneousMatrix> matrices;
  for (const auto& X : poses) matrices.push_back(toVisp(X));
  return matrices;
}

Eigen::Isometry3d fromVisp(const vpHomogeneousMatrix& M) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 4; ++column) X.matrix()(row, column) = M[row][column];
  return X;
}

}  // namespace

std::optional<Eigen::Isometry3d> calibrateByVisp(const std::vector<Eigen::Isometry3d>& X_CM,
                                                 const std::vector<Eigen::Isometry3d>& X_BF) {
  vpHomogeneousMatrix eMc;
  const SilentOutput silent;
  try {
    if (vpHandEyeCalibration::calibrate(toVisp(X_CM), toVisp(X_BF), eMc) != 0) return std::nullopt;
  } catch (const vpException&) {
    return std::nullopt;
  }
  return fromVisp(eMc);
}

}  // namespace mirrorarm::calibration
