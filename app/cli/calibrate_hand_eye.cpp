#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <numbers>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "core/calibration/hand_eye_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::cli {
namespace {

using namespace calibration;

constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

struct Wish {
  std::string pairs;
  std::string eye = std::string(name(CameraMount::kInHand));
  std::string method = "refined";
  std::string out;
};

const std::map<std::string, HandEyeMethod> kMethods = {
    {"visp", HandEyeMethod::kTsaiLenzVisp},
    {"tsai-lenz", HandEyeMethod::kTsaiLenzAllPairs},
    {"park", HandEyeMethod::kParkMartin},
    {"refined", HandEyeMethod::kRefined},
};

HandEye record(const HandEyeSolution& solution, CameraMount mount, std::size_t pairs) {
  HandEye hand_eye;
  hand_eye.mount = mount;
  hand_eye.X_PC = solution.X_PC;
  hand_eye.calibration = {isoUtcNow(),
                          std::string(name(solution.method)),
                          static_cast<int>(pairs - solution.outliers.size()),
                          solution.rms_m,
                          solution.rms_rad,
                          solution.sigma_m};
  return hand_eye;
}

nlohmann::ordered_json stationTable(const HandEyeSolution& solution) {
  auto table = nlohmann::ordered_json::array();
  for (const auto& station : solution.stations)
    table.push_back({{"residual_mm", station.position_m * 1e3},
                     {"residual_deg", station.rotation_rad * kRadianInDegrees},
                     {"outlier", station.is_outlier}});
  return table;
}

void fill(nlohmann::ordered_json& result, const HandEyeSolution& solution, std::size_t pairs) {
  const Eigen::Vector3d p = solution.X_PC.translation();
  const auto q = rotationOf(solution.X_PC);
  result["translation_m"] = {p.x(), p.y(), p.z()};
  result["rotation_xyzw"] = {q.x(), q.y(), q.z(), q.w()};
  result["residual_mm"] = solution.rms_m * 1e3;
  result["residual_deg"] = solution.rms_rad * kRadianInDegrees;
  result["sigma_mm"] = solution.sigma_m ? nlohmann::ordered_json(*solution.sigma_m * 1e3) : nullptr;
  result["pairs"] = pairs;
  result["outliers"] = solution.outliers;
  result["turned"] = solution.turned;
  result["method"] = name(solution.method);
  result["stations"] = stationTable(solution);
}

void tell(const HandEyeSolution& solution, std::size_t pairs, const std::string& out) {
  const Eigen::Vector3d p = solution.X_PC.translation() * 1e3;
  std::cout << std::fixed << std::setprecision(2) << "Camera at " << p.x() << ", " << p.y() << ", " << p.z()
            << " mm; residual " << solution.rms_m * 1e3 << " mm, " << solution.rms_rad * kRadianInDegrees
            << " deg over " << pairs - solution.outliers.size() << " of " << pairs << " stations, by "
            << name(solution.method) << "; written to " << out << "\n";
  for (const auto station : solution.outliers)
    std::cout << "Left out: station " << station << ", counted from 0\n";
  for (const auto station : solution.turned)
    std::cout << "Board seen half a turn round, turned back: station " << station << "\n";
}

void run(const Wish& wish, Context& context) {
  const auto mount = *cameraMountOf(wish.eye);
  const auto pairs = orRefuse(readPosePairs(wish.pairs));
  const auto solution = solveHandEye(pairs, mount, kMethods.at(wish.method));
  if (!solution) throw InputRefused(wish.pairs + ": " + reason(solution.error()));
  orFail(writeHandEye(wish.out, record(*solution, mount, pairs.size())));
  fill(context.result, *solution, pairs.size());
  if (!context.json) tell(*solution, pairs.size(), wish.out);
}

}  // namespace

void addCalibrateHandEye(CLI::App& calibrate, Context& context) {
  CLI::App* command =
      addCommand(calibrate, context, "hand-eye", "Where the camera sits on the flange, or in the base",
                 "mirrorarm-cli calibrate hand-eye pairs.csv --out hand_eye.yaml --json");
  const auto wish = std::make_shared<Wish>();
  command
      ->add_option("pairs", wish->pairs, "Pose pairs, CSV: flange in base, object in camera, a row a station")
      ->required();
  command->add_option("--eye", wish->eye, "What carries the camera")
      ->check(CLI::IsMember(std::vector<std::string>{"in-hand", "to-hand"}))
      ->capture_default_str();
  command->add_option("--method", wish->method, "Solver; refined is the best")
      ->check(CLI::IsMember(std::vector<std::string>{"visp", "tsai-lenz", "park", "refined"}))
      ->capture_default_str();
  command->add_option("--out", wish->out, "The hand_eye.yaml to write")->required();
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
