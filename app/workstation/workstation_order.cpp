#include "app/workstation/workstation_order.h"

#include "core/common/resources.h"

namespace mirrorarm::workstation {

std::filesystem::path storeOf(const WorkstationOrder& order) {
  if (!order.store.empty()) return order.store;
  if (!order.tour.empty()) return order.tour / "store.sqlite";
  return dataFolder() / "store.sqlite";
}

std::filesystem::path calibrationsOf(const WorkstationOrder& order) {
  if (!order.calibrations.empty()) return order.calibrations;
  return (order.tour.empty() ? dataFolder() : order.tour) / "calibrations";
}

}  // namespace mirrorarm::workstation
