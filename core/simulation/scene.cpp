#include "core/simulation/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorarm::simulation {
namespace {

constexpr std::array<std::string_view, 3> kCarriers{"table", "forearm", "ur5"};

int stepsAlong(double size_m, double step_m) { return static_cast<int>(std::floor(size_m / step_m + 1e-6)); }

}  // namespace

std::string_view id(Carrier carrier) { return kCarriers[static_cast<std::size_t>(carrier)]; }

std::optional<Carrier> carrierOf(std::string_view text) {
  const auto found = std::ranges::find(kCarriers, text);
  if (found == kCarriers.end()) return std::nullopt;
  return static_cast<Carrier>(found - kCarriers.begin());
}

std::vector<Eigen::Vector3d> stationsOf(const Scene::Grid& grid) {
  const Eigen::Vector3i last(stepsAlong(grid.size_m.x(), grid.step_m),
                             stepsAlong(grid.size_m.y(), grid.step_m),
                             stepsAlong(grid.size_m.z(), grid.step_m));
  std::vector<Eigen::Vector3d> stations;
  for (int z = 0; z <= last.z(); ++z)
    for (int y = 0; y <= last.y(); ++y)
      for (int x = 0; x <= last.x(); ++x) {
        const int back_and_forth_y = z % 2 == 0 ? y : last.y() - y;
        const int back_and_forth_x = (z * (last.y() + 1) + y) % 2 == 0 ? x : last.x() - x;
        const Eigen::Vector3d place(back_and_forth_x, back_and_forth_y, z);
        stations.push_back(grid.step_m * (place - 0.5 * last.cast<double>()));
      }
  return stations;
}

}  // namespace mirrorarm::simulation
