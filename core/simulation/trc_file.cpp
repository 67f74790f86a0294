#include "core/simulation/trc_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "core/common/csv.h"

namespace mirrorarm::simulation {
namespace {

/// Caught by readTrc alone.
struct Problem {
  int line = 0;
  std::string reason;
};

struct Row {
  int line = 0;
  std::vector<std::string> cells;  ///< without empty ones at the end
  std::size_t written = 0;         ///< with them
};

struct Text {
  std::vector<Row> rows;  ///< without blank ones
  bool ended = true;      ///< the last one has its line end
};

constexpr std::array<std::string_view, 8> kKeys{"DataRate",           "CameraRate",   "NumFrames",
                                                "NumMarkers",         "Units",        "OrigDataRate",
                                                "OrigDataStartFrame", "OrigNumFrames"};
constexpr std::size_t kHeaderRows = 5;

Text textOf(std::istream& in) {
  Text text;
  std::string line_text;
  std::getline(in, line_text);
  if (!line_text.starts_with("PathFileType")) throw Problem{1, "does not start with PathFileType"};
  const char separator = line_text.find('\t') != std::string::npos ? '\t' : ',';
  for (int line = 1;; ++line) {
    text.ended = !in.eof();
    Row row{line, splitCells(line_text, separator), 0};
    row.written = row.cells.size();
    while (!row.cells.empty() && row.cells.back().empty()) row.cells.pop_back();
    if (!row.cells.empty()) text.rows.push_back(std::move(row));
    if (!std::getline(in, line_text)) return text;
  }
}

double numberIn(const Row& row, std::size_t cell, const std::string& what) {
  double value = 0.0;
  if (cell < row.cells.size() && parseNumber(row.cells[cell], value)) return value;
  throw Problem{row.line, what + " is missing or not a finite number"};
}

struct Header {
  double rate_hz = 0.0;
  double frames = 0.0;
  std::size_t markers = 0;
  double metres = 0.0;  ///< of one unit
};

Header headerOf(const std::vector<Row>& rows) {
  if (rows.size() < kHeaderRows) throw Problem{rows.back().line, "ends within the header"};
  if (rows[0].cells.size() < 3 || rows[0].cells[1] != "4" || rows[0].cells[2] != "(X/Y/Z)")
    throw Problem{1, "PathFileType is not 4 (X/Y/Z)"};
  if (!std::ranges::equal(rows[1].cells, kKeys))
    throw Problem{rows[1].line, "has not the eight header keys of a TRC file"};
  const Row& values = rows[2];
  Header header;
  header.rate_hz = numberIn(values, 0, "DataRate");
  header.frames = numberIn(values, 2, "NumFrames");
  const double markers = numberIn(values, 3, "NumMarkers");
  if (header.rate_hz <= 0.0) throw Problem{values.line, "DataRate is not positive"};
  if (markers < 1.0 || markers > 10000.0 || markers != std::floor(markers))
    throw Problem{values.line, "NumMarkers is not a sound number"};
  header.markers = static_cast<std::size_t>(markers);
  const std::string& units = values.cells.size() > 4 ? values.cells[4] : std::string();
  if (units != "mm" && units != "m") throw Problem{values.line, "Units is neither mm nor m"};
  header.metres = units == "mm" ? 1e-3 : 1.0;
  return header;
}

/// First cell of each wanted marker.
std::vector<std::size_t> columnsOf(const Row& names, std::span<const std::string_view> wanted) {
  std::vector<std::size_t> columns;
  for (const auto name : wanted) {
    const auto first = std::ranges::find(names.cells, name);
    if (first == names.cells.end()) throw Problem{names.line, "marker " + std::string(name) + " is missing"};
    if (std::find(first + 1, names.cells.end(), name) != names.cells.end())
      throw Problem{names.line, "marker " + std::string(name) + " is named twice"};
    const auto column = static_cast<std::size_t>(first - names.cells.begin());
    if (column < 2 || (column - 2) % 3 != 0)
      throw Problem{names.line,
                    "marker " + std::string(name) + " does not stand above its three coordinates"};
    columns.push_back(column);
  }
  return columns;
}

void checkNames(const std::vector<Row>& rows, const Header& header) {
  const Row& names = rows[3];
  if (names.cells.size() < 2 || names.cells[0] != "Frame#" || names.cells[1] != "Time")
    throw Problem{names.line, "does not start with Frame# and Time"};
  const auto named = std::ranges::count_if(names.cells, [](const auto& cell) { return !cell.empty(); }) - 2;
  if (named != static_cast<std::ptrdiff_t>(header.markers))
    throw Problem{names.line, "names " + std::to_string(named) + " markers where NumMarkers is " +
                                  std::to_string(header.markers)};
  const Row& axes = rows[4];
  if (axes.cells.size() != 2 + 3 * header.markers)
    throw Problem{axes.line, "does not name three coordinates for each marker"};
  for (std::size_t i = 2; i < axes.cells.size(); ++i)
    if (axes.cells[i] != "XYZ"[(i - 2) % 3] + std::to_string((i - 2) / 3 + 1))
      throw Problem{axes.line, "'" + axes.cells[i] + "' is not the coordinate expected there"};
}

/// Number and time of the row must follow those of the first one without a gap.
void checkPlace(const Row& row, const Row& first, std::size_t place, double rate_hz) {
  const double expected = numberIn(first, 0, "frame number") + static_cast<double>(place);
  if (numberIn(row, 0, "frame number") != expected) throw Problem{row.line, "frame numbers have a gap"};
  const double late_s =
      numberIn(row, 1, "time") - numberIn(first, 1, "time") - static_cast<double>(place) / rate_hz;
  if (std::abs(late_s) > 0.5 / rate_hz) throw Problem{row.line, "time does not fit DataRate"};
}

void checkCells(const Row& row, std::size_t expected) {
  if (row.written < expected)
    throw Problem{row.line, "has " + std::to_string(row.written) + " cells where the markers need " +
                                std::to_string(expected)};
  if (row.cells.size() > expected) throw Problem{row.line, "has more cells than markers need"};
  for (std::size_t i = 2; i < row.cells.size(); ++i)
    if (!row.cells[i].empty()) static_cast<void>(numberIn(row, i, "cell " + std::to_string(i + 1)));
}

std::vector<Eigen::Vector3d> pointsOf(const Row& row, const std::vector<std::size_t>& columns,
                                      std::span<const std::string_view> wanted, double metres) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string what = "marker " + std::string(wanted[i]);
    points.push_back(metres * Eigen::Vector3d(numberIn(row, columns[i], what),
                                              numberIn(row, columns[i] + 1, what),
                                              numberIn(row, columns[i] + 2, what)));
  }
  return points;
}

MarkerMotion motionOf(const Text& text, std::span<const std::string_view> wanted) {
  const auto& rows = text.rows;
  const Header header = headerOf(rows);
  checkNames(rows, header);
  const auto columns = columnsOf(rows[3], wanted);
  const std::span samples(rows.begin() + kHeaderRows, rows.end());
  if (samples.size() < 2) throw Problem{rows.back().line, "holds fewer than two frames"};
  if (static_cast<double>(samples.size()) > header.frames)
    throw Problem{rows.back().line, "holds more rows than NumFrames"};
  if (!text.ended && static_cast<double>(samples.size()) < header.frames)
    throw Problem{rows.back().line, "ends within a row"};
  MarkerMotion motion{header.rate_hz, {wanted.begin(), wanted.end()}, {}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    checkPlace(samples[i], samples[0], i, header.rate_hz);
    checkCells(samples[i], 2 + 3 * header.markers);
    motion.positions_m.push_back(pointsOf(samples[i], columns, wanted, header.metres));
  }
  return motion;
}

}  // namespace

FromFile<MarkerMotion> readTrc(const std::filesystem::path& file, std::span<const std::string_view> wanted) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) return unexpected(FileError{file, 0, "cannot be read"});
  try {
    return motionOf(textOf(in), wanted);
  } catch (const Problem& problem) {
    return unexpected(FileError{file, problem.line, problem.reason});
  }
}

}  // namespace mirrorarm::simulation
