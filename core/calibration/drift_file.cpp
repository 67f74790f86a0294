#include "core/calibration/drift_file.h"

#include <iomanip>

#include "core/calibration/yaml_range.h"
#include "core/common/atomic_file.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::string_view kFormat = "mirrorarm/drift/1";

DriftVerdict verdictOf(const YamlNode& node) {
  const auto verdict = driftVerdictOf(node.text());
  if (!verdict) node.refuse("is none of holds, doubtful, failed");
  return *verdict;
}

DriftFindings::Grid gridOf(const YamlNode& node) {
  node.allowOnly({"std_mm", "scale_percent", "stations"});
  DriftFindings::Grid grid;
  grid.std_mm = node["std_mm"].vector3();
  if (grid.std_mm.minCoeff() < 0.0) node["std_mm"].refuse("is negative");
  grid.scale_percent = node["scale_percent"].number();
  grid.stations = countOf(node["stations"]);
  return grid;
}

DriftRecord driftRecord(const YamlNode& root) {
  root.allowOnly(
      {"format", "date", "verdict", "epipolar_px", "reprojection_px", "length_percent", "points", "grid"});
  DriftRecord record;
  record.date = root["date"].text();
  auto& findings = record.findings;
  findings.verdict = verdictOf(root["verdict"]);
  findings.epipolar_px = atLeastZero(root["epipolar_px"]);
  findings.reprojection_px = atLeastZero(root["reprojection_px"]);
  findings.length_percent = root["length_percent"].number();
  findings.points = countOf(root["points"]);
  if (root.has("grid")) findings.grid = gridOf(root["grid"]);
  return record;
}

void writeGrid(std::ostream& out, const DriftFindings::Grid& grid) {
  out << "grid:\n  std_mm: [" << grid.std_mm.x() << ", " << grid.std_mm.y() << ", " << grid.std_mm.z()
      << "]\n  scale_percent: " << grid.scale_percent << "\n  stations: " << grid.stations << '\n';
}

}  // namespace

FromFile<DriftRecord> readDriftRecord(const std::filesystem::path& file) {
  return readYaml(file, kFormat, driftRecord);
}

Expected<void, std::string> writeDriftRecord(const std::filesystem::path& file, const DriftRecord& record) {
  return writeWhole(file, [&record](std::ostream& out) {
    const auto& findings = record.findings;
    out << "format: " << kFormat << "\ndate: " << std::quoted(record.date)
        << "\nverdict: " << id(findings.verdict) << "\nepipolar_px: " << findings.epipolar_px
        << "\nreprojection_px: " << findings.reprojection_px
        << "\nlength_percent: " << findings.length_percent << "\npoints: " << findings.points << '\n';
    if (findings.grid) writeGrid(out, *findings.grid);
  });
}

}  // namespace mirrorarm::calibration
