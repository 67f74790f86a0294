#include <iostream>
#include <limits>
#include <memory>
#include <numbers>

#include "app/cli/commands.h"
#include "core/tracking/layout_report.h"
#include "core/tracking/target_file.h"

namespace mirrorarm::cli {
namespace {

using tracking::LayoutReport;
using tracking::Target;

std::vector<Target> readAll(const std::vector<std::filesystem::path>& files) {
  std::vector<Target> targets;
  for (const auto& file : files) targets.push_back(orRefuse(tracking::readTarget(file)));
  return targets;
}

nlohmann::ordered_json asJson(const LayoutReport& report) {
  nlohmann::ordered_json issues = nlohmann::ordered_json::array();
  for (const auto issue : report.issues) issues.push_back(std::string(id(issue)));
  nlohmann::ordered_json json = {{"target", report.target},
                                 {"markers", report.markers},
                                 {"length_mm", 1e3 * report.length_m},
                                 {"width_mm", 1e3 * report.width_m},
                                 {"thickness_mm", 1e3 * report.thickness_m},
                                 {"smallest_distance_mm", 1e3 * report.smallest_distance_m},
                                 {"turn_sigma_deg", report.turn_sigma_rad * 180.0 / std::numbers::pi},
                                 {"symmetric_rms_mm", nullptr},
                                 {"alike_markers", report.alike_markers},
                                 {"needed_markers", report.needed_markers},
                                 {"issues", issues}};
  if (report.symmetric_rms_m < std::numeric_limits<double>::infinity())
    json["symmetric_rms_mm"] = 1e3 * report.symmetric_rms_m;
  return json;
}

void tell(const LayoutReport& report) {
  std::cout.precision(3);
  std::cout << report.target << ": " << report.markers << " markers, " << 1e3 * report.length_m << " x "
            << 1e3 * report.width_m << " mm rms, turn to " << report.turn_sigma_rad * 180.0 / std::numbers::pi
            << " degrees at 0.4 m, " << report.needed_markers << " must be seen for a unique answer\n";
}

void check(const std::vector<std::filesystem::path>& files, Context& context) {
  const auto targets = readAll(files);
  nlohmann::ordered_json reports = nlohmann::ordered_json::array();
  for (const auto& target : targets) {
    const LayoutReport report = tracking::checkLayout(target);
    reports.push_back(asJson(report));
    if (!context.json) tell(report);
  }
  nlohmann::ordered_json look_alikes = nlohmann::ordered_json::array();
  for (const auto& pair : tracking::findLookAlikes(targets))
    look_alikes.push_back({{"a", pair.a},
                           {"b", pair.b},
                           {"shared_markers", pair.shared_markers},
                           {"needed_markers", pair.needed_markers}});
  const auto warnings = tracking::layoutWarnings(targets);
  context.result = {{"targets", reports}, {"look_alikes", look_alikes}, {"warnings", warnings}};
  if (context.json) return;
  for (const auto& line : warnings) std::cout << "warning: " << line << "\n";
}

}  // namespace

void addTarget(CLI::App& app, Context& context) {
  CLI::App* target = app.add_subcommand("target", "Look at taught targets");
  target->require_subcommand(1);
  CLI::App* command =
      addCommand(*target, context, "check", "Tell what is ambiguous or uncertain about the markers' places",
                 "mirrorarm-cli target check forearm.yaml upper_arm.yaml");
  const auto files = std::make_shared<std::vector<std::filesystem::path>>();
  command->add_option("FILE", *files, "Targets; of several also whether they look alike")->required();
  command->callback([files, &context] { check(*files, context); });
}

}  // namespace mirrorarm::cli
