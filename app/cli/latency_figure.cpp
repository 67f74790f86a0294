#include "app/cli/latency_figure.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace mirrorarm::cli {
namespace {

using experiments::FollowMoment;
using experiments::MoveLatency;
using experiments::WayOf;

constexpr double kWidth = 720.0, kHeight = 400.0, kLeft = 60.0, kRight = 20.0, kTop = 30.0, kBottom = 50.0;
constexpr double kBefore_s = 0.2, kAfter_s = 1.0;  // of the move

/// From time and way to the place on the page.
struct Page {
  double from_s = 0.0, to_s = 1.0, to_mm = 100.0;
  [[nodiscard]] double x(double time_s) const {
    return kLeft + (kWidth - kLeft - kRight) * (time_s - from_s) / (to_s - from_s);
  }
  [[nodiscard]] double y(double way_mm) const {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * way_mm / to_mm;
  }
};

void curve(std::ostream& out, const Page& page, const std::vector<FollowMoment>& moments, const WayOf& way,
           const char* colour, const char* dashes) {
  out << R"(<polyline fill="none" stroke-width="2" stroke=")" << colour << R"(" stroke-dasharray=")" << dashes
      << R"(" points=")";
  for (const FollowMoment& moment : moments)
    if (moment.time_s >= page.from_s && moment.time_s <= page.to_s)
      out << page.x(moment.time_s) << ',' << page.y(1e3 * way(moment)) << ' ';
  out << "\"/>\n";
}

void text(std::ostream& out, double x, double y, const std::string& words, const char* anchor = "middle") {
  out << R"(<text x=")" << x << R"(" y=")" << y << R"(" text-anchor=")" << anchor << R"(">)" << words
      << "</text>\n";
}

void verticalAt(std::ostream& out, double x, const char* colour) {
  out << R"(<line x1=")" << x << R"(" x2=")" << x << R"(" y1=")" << kTop << R"(" y2=")" << kHeight - kBottom
      << R"(" stroke=")" << colour << R"(" stroke-dasharray="4 4"/>)"
      << "\n";
}

void axes(std::ostream& out, const Page& page) {
  out << R"(<path fill="none" stroke="#444" d="M)" << kLeft << ' ' << kTop << 'V' << kHeight - kBottom << 'H'
      << kWidth - kRight << R"("/>)"
      << "\n";
  constexpr double step_s = 0.5, step_mm = 20.0;
  for (double t = 0.0; t <= page.to_s - page.from_s; t += step_s) {
    std::ostringstream label;
    label << t;
    text(out, page.x(page.from_s + t), kHeight - kBottom + 18.0, label.str());
  }
  for (double mm = 0.0; mm <= page.to_mm; mm += step_mm)
    text(out, kLeft - 8.0, page.y(mm) + 4.0, std::to_string(static_cast<int>(mm)), "end");
  text(out, 0.5 * (kLeft + kWidth - kRight), kHeight - 12.0, "time [s]");
  text(out, kLeft, kTop - 12.0, "way [mm]", "start");
}

/// The move whose onset is nearest to the mean of all.
const MoveLatency& typical(const experiments::LatencyResult& result) {
  return *std::ranges::min_element(result.moves, {}, [&](const MoveLatency& move) {
    return std::abs(move.onset_ms - result.onset.mean_ms);
  });
}

}  // namespace

std::string latencyFigure(const experiments::LatencyResult& result) {
  std::ostringstream out;
  const MoveLatency& move = typical(result);
  const Page page{move.move.start_s - kBefore_s, move.move.end_s() + kAfter_s,
                  1e3 * move.move.shift_m.norm() * 1.1};
  const WayOf target = wayAlong(move.move, result.run.moments, &FollowMoment::target_m);
  const WayOf tool = wayAlong(move.move, result.run.moments, &FollowMoment::tool_m);
  const auto beginOf = [&](const WayOf& way) {
    return timeOfWay(result.run.moments, move.move.start_s, experiments::kOnset_m, way);
  };
  out << std::fixed << std::setprecision(1) << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << kWidth
      << R"(" height=")" << kHeight << R"(" font-family="sans-serif" font-size="12">)"
      << "\n"
      << R"(<rect width="100%" height="100%" fill="white"/>)"
      << "\n";
  axes(out, page);
  curve(out, page, result.paper_moments, wayAlong(move.move, result.paper_moments, &FollowMoment::tool_m),
        "#999999", "6 4");
  curve(out, page, result.run.moments, target, "#d55e00", "none");
  curve(out, page, result.run.moments, tool, "#0072b2", "none");
  verticalAt(out, page.x(beginOf(target)), "#d55e00");
  verticalAt(out, page.x(beginOf(tool)), "#0072b2");
  text(out, kWidth - kRight, kTop + 170.0, "orange: target, held by the second robot", "end");
  text(out, kWidth - kRight, kTop + 188.0, "blue: the robot that follows", "end");
  text(out, kWidth - kRight, kTop + 206.0, "grey: model of the paper's scheme", "end");
  std::ostringstream onset;
  onset << std::fixed << std::setprecision(0) << "onset " << move.onset_ms << " ms, at 50 mm "
        << move.lag_at_50mm_ms << " ms";
  text(out, kWidth - kRight, kTop + 224.0, onset.str(), "end");
  out << "</svg>\n";
  return out.str();
}

std::string momentsCsv(const experiments::LatencyResult& result) {
  std::ostringstream out;
  out << "time_s,target_x_m,target_y_m,target_z_m,tool_x_m,tool_y_m,tool_z_m\n" << std::setprecision(9);
  for (const FollowMoment& moment : result.run.moments)
    out << moment.time_s << ',' << moment.target_m.x() << ',' << moment.target_m.y() << ','
        << moment.target_m.z() << ',' << moment.tool_m.x() << ',' << moment.tool_m.y() << ','
        << moment.tool_m.z() << '\n';
  return out.str();
}

}  // namespace mirrorarm::cli
