#include "core/station/black_box_file.h"

#include "core/common/atomic_file.h"

namespace mirrorarm::station {
namespace {

void writeHeader(std::ostream& out, Eigen::Index joints) {
  out << "time_ns,permit,stop,guard";
  for (const char* group : {"measured_q", "measured_v", "commanded_q", "commanded_v", "commanded_a"})
    for (Eigen::Index joint = 1; joint <= joints; ++joint) out << ',' << group << joint;
  out << '\n';
}

void writeRow(std::ostream& out, const control::ServoState& state) {
  out << toNanoseconds(state.time) << ',' << static_cast<int>(state.permit) << ',' << id(state.stop) << ','
      << id(state.guard);
  for (const auto* group : {&state.measured.q_rad, &state.measured.v_rad_s, &state.commanded.q_rad,
                            &state.commanded.v_rad_s, &state.commanded.a_rad_s2})
    for (const double value : *group) out << ',' << value;
  out << '\n';
}

}  // namespace

Expected<void, std::string> writeBlackBox(const std::filesystem::path& file,
                                          std::span<const control::ServoState> states) {
  return writeWhole(file, [&](std::ostream& out) {
    writeHeader(out, states.empty() ? 0 : states.front().commanded.q_rad.size());
    for (const auto& state : states) writeRow(out, state);
  });
}

}  // namespace mirrorarm::station
