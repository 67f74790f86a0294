#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace mirrorarm::workstation {

/// How the workstation is opened on the simulated bench.
struct WorkstationOrder {
  std::filesystem::path store;   ///< records; empty: the user's own store
  std::filesystem::path motion;  ///< a TRC file that moves the healthy arm; empty: `exercise`
  std::string exercise = "reach";
  std::uint64_t seed = 1;
  bool dark = false;
  std::array<int, 2> size_px{1600, 1000};  ///< width and height of the window
  std::filesystem::path tour;  ///< a folder: walk through a session and leave a picture of each step there
  std::string language = "en";
};

/// Opens the window and gives the program's exit code: 0 done, 2 wrong input, 1 where the tour or the station
/// failed; one line on standard error says why.
[[nodiscard]] int runWorkstation(const WorkstationOrder& order, int argc, char** argv);

}  // namespace mirrorarm::workstation
