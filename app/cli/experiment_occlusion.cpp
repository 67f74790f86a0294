#include <sstream>

#include "app/cli/experiment_commands.h"
#include "core/common/resources.h"
#include "core/experiments/occlusion.h"
#include "core/experiments/paper_figures.h"

namespace mirrorarm::cli {
namespace {

using experiments::OcclusionRow;
using experiments::PoseStatistics;

nlohmann::ordered_json jsonOf(const PoseStatistics& of) {
  return {{"tracked_share", of.trackedShare()},
          {"fit_rms_mm", of.fit_rms_mm},
          {"rms_mm", of.rms_mm},
          {"std_mm", {of.std_mm.x(), of.std_mm.y(), of.std_mm.z()}},
          {"turn_rms_deg", of.turn_rms_deg}};
}

/// The keys at the top are those of the most covered markers.
nlohmann::ordered_json jsonOf(const std::vector<OcclusionRow>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const OcclusionRow& row : rows)
    all.push_back({{"covered_share", row.covered_share},
                   {"ours", jsonOf(row.ours)},
                   {"paper_method", jsonOf(row.paper)}});
  const OcclusionRow& worst = rows.back();
  return {{"covered_share", worst.covered_share},
          {"tracked_share", worst.ours.trackedShare()},
          {"fit_rms_mm", worst.ours.fit_rms_mm},
          {"rms_mm", worst.ours.rms_mm},
          {"rows", all},
          {"paper",
           {{"covered_share", experiments::paper::kMostCovered},
            {"fit_rms_mm", experiments::paper::kFitRms_mm}}}};
}

std::string line(const std::string& method, const PoseStatistics& of) {
  return "| " + method + " | " + fixedNumber(100.0 * of.trackedShare(), 1) + " % | " +
         fixedNumber(of.fit_rms_mm, 3) + " | " + fixedNumber(of.std_mm.x(), 3) + " / " +
         fixedNumber(of.std_mm.y(), 3) + " / " + fixedNumber(of.std_mm.z(), 3) + " | " +
         fixedNumber(of.rms_mm, 3) + " | " + fixedNumber(of.turn_rms_deg, 3) + " |\n";
}

std::string tableOf(const std::vector<OcclusionRow>& rows) {
  std::ostringstream out;
  out << "# Covered markers\n\n"
         "The paper's cuboid of 60 x 60 x 40 mm in steps of 20 mm, 0.4 m above a target of ten markers; "
         "others "
         "covered in each frame.\nErrors against the simulated truth; std of the target's origin along the "
         "left "
         "camera's axes. The paper's whole system, cameras and hand-eye calibrated, nothing covered: std "
      << experiments::paper::kStd_mm[0] << " / " << experiments::paper::kStd_mm[1] << " / "
      << experiments::paper::kStd_mm[2] << " mm, fit " << experiments::paper::kFitRms_mm
      << " mm; half of the markers covered: \"still able to register\".\n\n"
         "| covered, method | tracked | fit rms [mm] | std x / y / z [mm] | rms [mm] | turn rms [deg] |\n"
         "|---|---|---|---|---|---|\n";
  for (const OcclusionRow& row : rows) {
    const std::string covered = fixedNumber(100.0 * row.covered_share, 0) + " %, ";
    out << line(covered + "ours", row.ours) << line(covered + "the paper's method", row.paper);
  }
  return out.str();
}

ExperimentReport measure() {
  const auto rows = experiments::measureOcclusion(resourceFolder());
  if (!rows) throw InputRefused(rows.error());
  return {jsonOf(*rows), tableOf(*rows)};
}

}  // namespace

void addExperimentOcclusion(CLI::App& experiment, Context& context) {
  addExperimentCommand(experiment, context, "occlusion", "Up to half of the markers covered (section 3.2)",
                       measure);
}

}  // namespace mirrorarm::cli
