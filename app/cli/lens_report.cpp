#include <cmath>
#include <iomanip>
#include <iostream>

#include "app/cli/calibrate_commands.h"

namespace mirrorarm::cli {
namespace {

using calibration::BoardImages;
using calibration::BoardShape;
using calibration::HoldOut;
using Json = nlohmann::ordered_json;

Json toJson(const HoldOut& figures) {
  return {{"epipolar_px", figures.epipolar_px},
          {"reprojection_px", figures.reprojection_px},
          {"square_mean_percent", figures.square_mean_percent},
          {"square_std_percent", figures.square_std_percent},
          {"depth_rms_mm", 1e3 * figures.depth_rms_m},
          {"views", figures.views},
          {"parts", figures.parts}};
}

Json toJson(const calibration::ViewResidual& view) {
  return {{"name", view.name},
          {"rms_px", view.rms_px},
          {"outlier", view.is_outlier},
          {"held_out", view.is_held_out},
          {"outlier_points", view.outlier_points},
          {"hold_out", view.hold_out ? toJson(*view.hold_out) : Json(nullptr)}};
}

Json toJson(const calibration::ModelTrial& trial) {
  return {{"model", camera::name(trial.model)},
          {"rms_px", trial.rms_px},
          {"hold_out_px", trial.hold_out_px},
          {"hold_out_epipolar_px", trial.hold_out_epipolar_px}};
}

Json toJson(const std::optional<BoardShape>& shape) {
  if (!shape) return nullptr;
  return {{"flatness_mm", 1e3 * shape->flatness_rms_m},
          {"flatness_sigma_mm", 1e3 * shape->flatness_sigma_m},
          {"stretch_percent", shape->stretch_percent},
          {"stretch_sigma_percent", shape->stretch_sigma_percent},
          {"bent", shape->is_bent},
          {"stretched", shape->is_stretched}};
}

template <class Items>
Json listOf(const Items& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(toJson(item));
  return list;
}

void tell(const HoldOut& figures) {
  if (figures.parts > 0)
    std::cout << "By cross-validation in " << figures.parts << " parts: ";
  else
    std::cout << "On " << figures.views << " views kept out: ";
  if (figures.epipolar_px > 0.0)
    std::cout << "epipolar " << figures.epipolar_px << " px rms, squares " << figures.square_mean_percent
              << " % off, std " << figures.square_std_percent << " %, depth " << 1e3 * figures.depth_rms_m
              << " mm rms, ";
  std::cout << "reprojection " << figures.reprojection_px << " px rms\n";
}

void tell(const BoardShape& shape) {
  if (shape.is_bent)
    std::cout << "The board is bent: its points lie " << 1e3 * shape.flatness_rms_m
              << " mm rms off a plane; use a stiff one\n";
  if (shape.is_stretched)
    std::cout << "The board is stretched: its steps along the rows are " << shape.stretch_percent
              << " % longer than across; print it anew without scaling\n";
}

}  // namespace

Json toJson(const camera::LensSigma& sigma) {
  return {{"fx_px", sigma.fx_px},
          {"fy_px", sigma.fy_px},
          {"cx_px", sigma.cx_px},
          {"cy_px", sigma.cy_px},
          {"distortion", sigma.distortion}};
}

void fillLensReport(const LensReport& report, const BoardImages& read, Context& context) {
  auto& result = context.result;
  result["rms_px"] = report.rms_px;
  result["hold_out"] = toJson(report.hold_out);
  result["model"] = camera::name(report.model);
  result["views"] = report.views;
  result["outliers"] = report.outliers;
  result["not_found"] = read.not_found;
  result["trials"] = listOf(report.trials);
  result["board"] = toJson(report.board_shape);
  result["residuals"] = listOf(report.residuals);
}

void tellLensReport(const LensReport& report, const BoardImages& read, const std::string& out) {
  std::cout << std::fixed << std::setprecision(3) << "Reprojection " << report.rms_px << " px rms over "
            << report.views << " views by " << camera::name(report.model) << "; written to " << out << "\n";
  tell(report.hold_out);
  if (report.trials.size() > 1)
    for (const auto& trial : report.trials)
      std::cout << "Tried " << camera::name(trial.model) << ": on views kept out " << trial.hold_out_px
                << " px rms\n";
  if (report.board_shape) tell(*report.board_shape);
  if (!report.outliers.empty())
    std::cout << "Left out, far worse than the others: " << joined(report.outliers) << "\n";
  if (const auto left_out = leftOut(read); !left_out.empty()) std::cout << "Left out: " << left_out << "\n";
}

}  // namespace mirrorarm::cli
