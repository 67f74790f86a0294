#include "core/calibration/visp_bridge.h"

#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

#include <visp3/vision/vpHandEyeCalibration.h>

namespace mirrorarm::calibration {
namespace {

/// While it lives, the process's standard output goes nowhere: ViSP prints a table at every call, by printf
/// too.
class SilentOutput {
 public:
  SilentOutput() : nowhere_(::open("/dev/null", O_WRONLY | O_CLOEXEC)), kept_(::dup(STDOUT_FILENO)) {
    flush();
    if (nowhere_ >= 0 && kept_ >= 0) ::dup2(nowhere_, STDOUT_FILENO);
  }
  ~SilentOutput() {
    flush();
    if (kept_ >= 0) ::dup2(kept_, STDOUT_FILENO);
    for (const int file : {nowhere_, kept_})
      if (file >= 0) ::close(file);
  }
  SilentOutput(const SilentOutput&) = delete;
  SilentOutput& operator=(const SilentOutput&) = delete;

 private:
  static void flush() {
    std::cout.flush();
    std::fflush(stdout);
  }
  int nowhere_;
  int kept_;
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
