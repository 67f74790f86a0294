#include "core/camera/note_yaml.h"

#include <algorithm>

namespace mirrorarm::camera {
namespace {

std::string textUnder(const YamlNode& node, std::string_view key) {
  return node.has(key) ? node[key].text() : std::string();
}

double numberUnder(const YamlNode& node, std::string_view key) {
  return node.has(key) ? node[key].number() : 0.0;
}

std::vector<std::string> textsUnder(const YamlNode& node, std::string_view key) {
  std::vector<std::string> texts;
  if (!node.has(key)) return texts;
  const auto list = node[key];
  for (std::size_t i = 0; i < list.size(); ++i) texts.push_back(list[i].text());
  return texts;
}

LensSigma readSigma(const YamlNode& node) {
  LensSigma sigma{numberUnder(node, "fx_px"),
                  numberUnder(node, "fy_px"),
                  numberUnder(node, "cx_px"),
                  numberUnder(node, "cy_px"),
                  {}};
  if (!node.has("distortion")) return sigma;
  const auto numbers = node["distortion"].numbers();
  if (numbers.size() > sigma.distortion.size()) node["distortion"].refuse("holds more than 5 numbers");
  std::copy(numbers.begin(), numbers.end(), sigma.distortion.begin());
  return sigma;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + '"';
}

void writeText(std::ostream& out, std::string_view key, std::string_view text) {
  if (!text.empty()) out << "  " << key << ": " << quoted(text) << "\n";
}

void writeTexts(std::ostream& out, std::string_view key, const std::vector<std::string>& texts) {
  if (texts.empty()) return;
  out << "  " << key << ":\n";
  for (const auto& text : texts) out << "    - " << quoted(text) << "\n";
}

void writeNumber(std::ostream& out, std::string_view key, double number) {
  if (number != 0.0) out << "  " << key << ": " << number << "\n";
}

void writeSigma(std::ostream& out, std::string_view key, const LensSigma& sigma) {
  if (sigma.fx_px == 0.0) return;
  out << "  " << key << ": {fx_px: " << sigma.fx_px << ", fy_px: " << sigma.fy_px
      << ", cx_px: " << sigma.cx_px << ", cy_px: " << sigma.cy_px << ", distortion: [";
  for (std::size_t i = 0; i < sigma.distortion.size(); ++i)
    out << (i == 0 ? "" : ", ") << sigma.distortion[i];
  out << "]}\n";
}

void writeBarSigma(std::ostream& out, const Eigen::Matrix<double, 6, 1>& sigma) {
  if (sigma.isZero(0.0)) return;
  out << "  bar_sigma: {turn_rad: [" << sigma[0] << ", " << sigma[1] << ", " << sigma[2] << "], shift_m: ["
      << sigma[3] << ", " << sigma[4] << ", " << sigma[5] << "]}\n";
}

void writeHoldOut(std::ostream& out, const CalibrationNote& note) {
  writeText(out, "hold_out_method", note.hold_out_method);
  writeNumber(out, "hold_out_px", note.hold_out_px);
  writeNumber(out, "hold_out_epipolar_px", note.hold_out_epipolar_px);
  writeNumber(out, "square_mean_percent", note.square_mean_percent);
  writeNumber(out, "square_std_percent", note.square_std_percent);
  writeNumber(out, "depth_rms_m", note.depth_rms_m);
}

}  // namespace

CalibrationNote readNote(const YamlNode& node) {
  CalibrationNote note;
  note.date = textUnder(node, "date");
  note.method = textUnder(node, "method");
  note.software = textUnder(node, "software");
  note.board = textUnder(node, "board");
  note.left_serial = textUnder(node, node.has("serial") ? "serial" : "left_serial");
  note.right_serial = textUnder(node, "right_serial");
  note.images = textsUnder(node, "images");
  note.held_out = textsUnder(node, "held_out");
  note.outliers = textsUnder(node, "outliers");
  note.rms_px = numberUnder(node, "rms_px");
  note.hold_out_method = textUnder(node, "hold_out_method");
  note.hold_out_px = numberUnder(node, "hold_out_px");
  note.hold_out_epipolar_px = numberUnder(node, "hold_out_epipolar_px");
  note.square_mean_percent = numberUnder(node, "square_mean_percent");
  note.square_std_percent = numberUnder(node, "square_std_percent");
  note.depth_rms_m = numberUnder(node, "depth_rms_m");
  for (const auto* key : {"sigma", "left_sigma"})
    if (node.has(key)) note.lens_sigma[0] = readSigma(node[key]);
  if (node.has("right_sigma")) note.lens_sigma[1] = readSigma(node["right_sigma"]);
  if (!node.has("bar_sigma")) return note;
  note.bar_sigma << node["bar_sigma"]["turn_rad"].vector3(), node["bar_sigma"]["shift_m"].vector3();
  return note;
}

void writeNote(std::ostream& out, const CalibrationNote& note, NoteOf of) {
  const bool is_rig = of == NoteOf::kRig;
  out << "calibration:\n  rms_px: " << note.rms_px << "\n";
  writeText(out, "date", note.date);
  writeText(out, "method", note.method);
  writeText(out, "software", note.software);
  writeText(out, "board", note.board);
  writeText(out, is_rig ? "left_serial" : "serial", note.left_serial);
  writeText(out, "right_serial", note.right_serial);
  writeHoldOut(out, note);
  writeSigma(out, is_rig ? "left_sigma" : "sigma", note.lens_sigma[0]);
  writeSigma(out, "right_sigma", note.lens_sigma[1]);
  writeBarSigma(out, note.bar_sigma);
  writeTexts(out, "images", note.images);
  writeTexts(out, "held_out", note.held_out);
  writeTexts(out, "outliers", note.outliers);
}

}  // namespace mirrorarm::camera
