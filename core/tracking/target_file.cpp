#include "core/tracking/target_file.h"

#include <algorithm>

#include "core/common/atomic_file.h"
#include "core/common/yaml.h"
#include "core/tracking/layout.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

constexpr auto kFormat = "mirrorarm/target/1";

std::vector<Eigen::Vector3d> readMarkers(const YamlNode& node) {
  if (node.size() > static_cast<std::size_t>(kMaxMarkers))
    node.refuse("holds more than " + std::to_string(kMaxMarkers) + " markers");
  std::vector<Eigen::Vector3d> markers;
  for (std::size_t i = 0; i < node.size(); ++i) markers.push_back(node[i].vector3());
  return markers;
}

Eigen::Matrix3d readCovariance(const YamlNode& node) {
  const auto s = node.numbers();
  if (s.size() != 6) node.refuse("does not hold six numbers");
  Eigen::Matrix3d covariance;
  covariance << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  if (!(covariance.diagonal().minCoeff() >= 0.0)) node.refuse("holds a negative variance");
  return covariance;
}

void checkLayout(const YamlNode& node, const Target& target) {
  if (target.markers_T.size() < 3) node.refuse("holds fewer than 3 markers");
  if (areCollinear(target.markers_T)) node.refuse("lie on one line");
  if (smallestDistance(target.markers_T) < target.marker_diameter_m)
    node.refuse("hold two markers closer than their diameter");
}

std::string readName(const YamlNode& node) {
  const std::string name = node.text();
  const auto breaks_tables = [](unsigned char c) { return c == ',' || c == '"' || c == '\'' || c < ' '; };
  if (name.empty() || std::any_of(name.begin(), name.end(), breaks_tables))
    node.refuse("is empty or holds a comma, a quotation mark, an apostrophe or a control character");
  return name;
}

Target parse(const YamlNode& root) {
  root.allowOnly({"format", "name", "marker_diameter_m", "markers_m", "markers_covariance_m2"});
  Target target;
  target.name = readName(root["name"]);
  target.marker_diameter_m = root["marker_diameter_m"].number();
  if (!(target.marker_diameter_m > 0.0)) root["marker_diameter_m"].refuse("is not above 0");
  const YamlNode markers = root["markers_m"];
  target.markers_T = readMarkers(markers);
  checkLayout(markers, target);
  if (!root.has("markers_covariance_m2")) return target;
  const YamlNode covariances = root["markers_covariance_m2"];
  if (covariances.size() != target.markers_T.size()) covariances.refuse("does not hold one item a marker");
  for (std::size_t i = 0; i < covariances.size(); ++i)
    target.markers_covariance_m2.push_back(readCovariance(covariances[i]));
  return target;
}

void write(std::ostream& out, const Target& target) {
  out << "format: " << kFormat << "\nname: '" << target.name
      << "'\nmarker_diameter_m: " << target.marker_diameter_m << "\nmarkers_m:\n";
  for (const auto& p : target.markers_T) out << "  - [" << p.x() << ", " << p.y() << ", " << p.z() << "]\n";
  if (target.markers_covariance_m2.empty()) return;
  out << "markers_covariance_m2:\n";
  for (const auto& c : target.markers_covariance_m2)
    out << "  - [" << c(0, 0) << ", " << c(0, 1) << ", " << c(0, 2) << ", " << c(1, 1) << ", " << c(1, 2)
        << ", " << c(2, 2) << "]\n";
}

}  // namespace

FromFile<Target> readTarget(const std::filesystem::path& file) { return readYaml(file, kFormat, parse); }

Expected<void, std::string> writeTarget(const std::filesystem::path& file, const Target& target) {
  return writeWhole(file, [&target](std::ostream& out) { write(out, target); });
}

}  // namespace mirrorarm::tracking
