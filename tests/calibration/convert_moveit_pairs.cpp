// Converts the pose samples of MoveIt's hand-eye tests into our pose pairs, to be solved with --eye to-hand:
//   convert_moveit_pairs pose_samples.json pairs.csv

#include <exception>
#include <iostream>
#include <stdexcept>

#include "tests/calibration/moveit_pairs.h"

int main(int argc, char** argv) try {
  using namespace mirrorarm::calibration;
  if (argc != 3) throw std::invalid_argument("usage: convert_moveit_pairs pose_samples.json pairs.csv");
  const auto written = writePosePairs(argv[2], readMoveItPairs(argv[1]));
  if (!written) throw std::runtime_error(written.error());
  return 0;
} catch (const std::exception& problem) {
  std::cerr << "convert_moveit_pairs: " << problem.what() << "\n";
  return 2;
}
