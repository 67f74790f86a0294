#include "core/calibration/hand_eye_residuals.h"

#include "core/calibration/station_misfit.h"

namespace mirrorarm::calibration {

std::vector<PosePair> asInHand(std::span<const PosePair> pairs, CameraMount mount) {
  std::vector<PosePair> turned(pairs.begin(), pairs.end());
  if (mount == CameraMount::kToHand)
    for (auto& pair : turned) pair.X_BF = pair.X_BF.inverse();
  return turned;
}

void fillResiduals(std::span<const PosePair> pairs, HandEyeSolution& solution) {
  std::vector<double> weights(pairs.size(), 1.0);
  for (const auto station : solution.outliers) weights[station] = 0.0;
  const auto misfit = stationMisfit(pairs, solution.X_PC, weights);
  solution.X_QM = misfit.X_BM;
  solution.rms_m = misfit.rms_m(weights);
  solution.rms_rad = misfit.rms_rad(weights);
  solution.stations.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    solution.stations.push_back({misfit.position_m[i], misfit.rotation_rad[i], weights[i] == 0.0});
}

}  // namespace mirrorarm::calibration
