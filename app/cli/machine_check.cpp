#include "app/cli/machine_check.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <filesystem>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <Eigen/Core>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/version.hpp>

#include "core/common/resources.h"
#include "core/devices/real_time.h"

namespace mirrorarm::cli {
namespace {

constexpr unsigned kFewestCores = 2;
constexpr double kLeastMemory_GiB = 3.5;
constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

bool isThere(const std::filesystem::path& path) {
  std::error_code failed;
  return std::filesystem::exists(path, failed);
}

MachineCheck cores() {
  const unsigned count = std::thread::hardware_concurrency();
  const bool enough = count >= kFewestCores;
  return {"cores", enough,
          std::to_string(count) +
              (enough ? " processor cores" : " processor cores; tracking left and right takes 2")};
}

MachineCheck memory() {
  const double bytes =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  const bool enough = bytes >= kLeastMemory_GiB * kGibibyte;
  const auto mebibytes = static_cast<long long>(bytes / 1024.0 / 1024.0);
  return {"memory", enough,
          std::to_string(mebibytes) + " MiB" + (enough ? "" : "; 4 GiB are needed for recordings")};
}

/// The name of the local X server's socket, or empty where the display is on another machine.
std::string socketOf(const std::string& display) {
  if (display.empty() || display.front() != ':') return "";
  std::string socket = "/tmp/.X11-unix/X";
  return socket.append(display, 1, display.find('.', 1) - 1);
}

MachineCheck display() {
  if (const auto wayland = variable("WAYLAND_DISPLAY"); !wayland.empty())
    return {"display", true, "Wayland display " + wayland};
  const auto x11 = variable("DISPLAY");
  if (x11.empty()) return {"display", false, "no DISPLAY or WAYLAND_DISPLAY: sessions run without a window"};
  const auto socket = socketOf(x11);
  if (!socket.empty() && !isThere(socket))
    return {"display", false, "DISPLAY is " + x11 + " but no server answers there"};
  return {"display", true, "X display " + x11};
}

MachineCheck openGl() {
  void* library = ::dlopen("libGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return {"opengl", false, "libGL.so.1 is missing: install libgl1"};
  ::dlclose(library);
  const bool has_card = isThere("/dev/dri/renderD128");
  return {"opengl", true,
          has_card ? "libGL and a graphics card" : "libGL; no graphics card, Mesa draws in software"};
}

/// Tried on a thread of its own, as the servo thread will: a limit alone does not tell what a container
/// forbids.
devices::RealTimeGrant triedRealTime() {
  devices::RealTimeGrant grant;
  std::thread([&grant] { grant = devices::askForRealTime(); }).join();
  return grant;
}

MachineCheck resources() {
  const auto folder = resourceFolder();
  const bool found = isThere(folder / "robots") && isThere(folder / "rigs");
  return {"resources", found,
          folder.string() + (found ? "" : " lacks robots or rigs: set MIRRORARM_RESOURCES")};
}

/// Where the workstation keeps its records unless told otherwise.
std::filesystem::path dataFolder() {
  const auto named = variable("XDG_DATA_HOME");
  const auto base =
      named.empty() ? std::filesystem::path(variable("HOME")) / ".local/share" : std::filesystem::path(named);
  return base / "mirrorarm";
}

/// The folder itself may not be there yet: then the nearest one above it counts.
MachineCheck data() {
  const auto folder = dataFolder();
  auto nearest = folder;
  while (!isThere(nearest) && nearest.has_relative_path()) nearest = nearest.parent_path();
  if (::access(nearest.c_str(), W_OK | X_OK) == 0)
    return {"data_folder", true, folder.string() + " can be written"};
  return {"data_folder", false, nearest.string() + " cannot be written: " + std::strerror(errno)};
}

MachineCheck libraries() {
  const std::string eigen = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
                            "." + std::to_string(EIGEN_MINOR_VERSION);
  const std::string opencv = cv::getVersionString();
  const bool fits =
      opencv.starts_with(std::to_string(CV_VERSION_MAJOR) + "." + std::to_string(CV_VERSION_MINOR));
  return {"libraries", fits,
          "OpenCV " + opencv + ", Eigen " + eigen + (fits ? "" : "; built against OpenCV " CV_VERSION)};
}

}  // namespace

std::vector<MachineCheck> checkMachine() {
  const auto grant = triedRealTime();
  return {cores(),
          memory(),
          display(),
          openGl(),
          {"real_time", grant.scheduling_error == 0, schedulingLine(grant)},
          {"locked_memory", grant.memory_error == 0, memoryLine(grant)},
          resources(),
          data(),
          libraries()};
}

}  // namespace mirrorarm::cli
