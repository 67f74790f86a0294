#include "core/vision/centres_file.h"

#include "core/common/atomic_file.h"

namespace mirrorarm::vision {
namespace {

constexpr std::string_view kHeader =
    "index,camera,x_px,y_px,sxx_px2,sxy_px2,syy_px2,major_px,minor_px,angle_rad,outline_fraction\n";

/// In quotation marks where the name would break the row (RFC 4180).
std::string cell(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void writeRow(std::ostream& out, const CentreRow& row) {
  const auto& marker = row.marker;
  const auto& s = marker.covariance_px2;
  out << row.index << ',' << cell(row.camera) << ',' << marker.centre_px.x() << ',' << marker.centre_px.y()
      << ',' << s(0, 0) << ',' << s(0, 1) << ',' << s(1, 1) << ',' << 2.0 * marker.ellipse.semi_major_px
      << ',' << 2.0 * marker.ellipse.semi_minor_px << ',' << marker.ellipse.angle_rad << ','
      << marker.outline_fraction << '\n';
}

}  // namespace

Expected<void, std::string> writeCentres(const std::filesystem::path& file, std::span<const CentreRow> rows) {
  return writeWhole(file, [&](std::ostream& out) {
    out << kHeader;
    for (const auto& row : rows) writeRow(out, row);
  });
}

}  // namespace mirrorarm::vision
