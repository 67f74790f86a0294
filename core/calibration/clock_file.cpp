#include "core/calibration/clock_file.h"

#include <iomanip>
#include <numbers>

#include "core/calibration/yaml_range.h"
#include "core/common/atomic_file.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::string_view kFormat = "mirrorarm/clock/1";
constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

double shareOf(const YamlNode& node) {
  const double value = atLeastZero(node);
  if (value > 1.0) node.refuse("is above 1");
  return value;
}

void readNote(const YamlNode& node, ClockRecord& record) {
  node.allowOnly({"date", "note", "correlation", "poses", "residual_mm", "residual_deg"});
  if (node.has("date")) record.date = node["date"].text();
  if (node.has("note")) record.note = node["note"].text();
  if (node.has("correlation")) record.correlation = shareOf(node["correlation"]);
  if (node.has("poses")) record.poses = countOf(node["poses"]);
  if (node.has("residual_mm")) record.median_m = atLeastZero(node["residual_mm"]) / 1e3;
  if (node.has("residual_deg")) record.median_rad = atLeastZero(node["residual_deg"]) / kRadianInDegrees;
}

ClockRecord clockRecord(const YamlNode& root) {
  root.allowOnly({"format", "offset_s", "sigma_s", "calibration"});
  ClockRecord record;
  record.offset_s = root["offset_s"].number();
  record.sigma_s = atLeastZero(root["sigma_s"]);
  if (root.has("calibration")) readNote(root["calibration"], record);
  return record;
}

}  // namespace

ClockRecord recordOf(const ClockOffset& offset, std::string date, std::string note) {
  ClockRecord record;
  record.offset_s = offset.offset_s;
  record.sigma_s = offset.sigma_s;
  record.date = std::move(date);
  record.note = std::move(note);
  record.correlation = offset.correlation;
  record.poses = offset.hand_eye.stations.size();
  record.median_m = offset.median_m;
  record.median_rad = offset.median_rad;
  return record;
}

FromFile<ClockRecord> readClockRecord(const std::filesystem::path& file) {
  return readYaml(file, kFormat, clockRecord);
}

Expected<void, std::string> writeClockRecord(const std::filesystem::path& file, const ClockRecord& record) {
  return writeWhole(file, [&record](std::ostream& out) {
    out << "format: " << kFormat << "\noffset_s: " << record.offset_s << "\nsigma_s: " << record.sigma_s
        << "\ncalibration:\n";
    if (!record.date.empty()) out << "  date: " << std::quoted(record.date) << '\n';
    if (!record.note.empty()) out << "  note: " << std::quoted(record.note) << '\n';
    out << "  correlation: " << record.correlation << "\n  poses: " << record.poses
        << "\n  residual_mm: " << record.median_m * 1e3
        << "\n  residual_deg: " << record.median_rad * kRadianInDegrees << '\n';
  });
}

}  // namespace mirrorarm::calibration
