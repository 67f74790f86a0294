#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace mirrorarm::simulation {

inline const std::vector<std::string> kForearmMarkers{"EPICl",    "EPICm", "LARMm",    "LARMl", "LARM_elb",
                                                      "LARM_ant", "STYLr", "STYLr_up", "STYLu", "WRIST"};

/// A TRC text with the forearm markers and one more, at 100 Hz; the arm swings along x.
inline std::string trcText(char separator, const std::string& units, int frames) {
  const double scale = units == "mm" ? 1000.0 : 1.0;
  const double places[10][3] = {{0, .04, 0},       {0, -.04, 0},    {.08, .03, .02},  {.1, -.03, .01},
                                {.02, 0, .04},     {.14, .01, .03}, {.25, .025, .01}, {.21, .03, .02},
                                {.25, -.03, .005}, {.23, 0, .03}};
  const std::string s(1, separator);
  std::ostringstream text;
  text << "PathFileType" << s << "4" << s << "(X/Y/Z)" << s << "made.trc\n"
       << "DataRate" << s << "CameraRate" << s << "NumFrames" << s << "NumMarkers" << s << "Units" << s
       << "OrigDataRate" << s << "OrigDataStartFrame" << s << "OrigNumFrames\n"
       << "100" << s << "100" << s << frames << s << "11" << s << units << s << "100" << s << "1" << s
       << frames << "\n"
       << "Frame#" << s << "Time" << s << "BOX" << s << s;
  for (const auto& name : kForearmMarkers) text << s << name << s << s;
  text << "\n" << s;
  for (int i = 1; i <= 11; ++i) text << s << "X" << i << s << "Y" << i << s << "Z" << i;
  text << "\n\n";
  for (int f = 0; f < frames; ++f) {
    text << f + 1 << s << 0.01 * f << s << s << s;  // the box is hidden
    for (const auto& p : places)
      text << s << scale * (p[0] + 0.05 * std::sin(0.02 * f)) << s << scale * p[1] << s << scale * p[2];
    text << "\n";
  }
  return text.str();
}

}  // namespace mirrorarm::simulation
