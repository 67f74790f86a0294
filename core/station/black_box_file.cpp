#include "core/station/black_box_file.h"

#include "core/common/atomic_file.h"

namespace mirrorarm::station {
namespace {

void writeHeader(std::ostream& out, Eigen::Index joints) {
  out << "time_ns,permit,stop,guard";
  for (const char* group :
       {"measured_q", "measured_v", "commanded_q", "commanded_v", "commanded_a", "sent_q", "sent_v"})
    for (Eigen::Index joint = 1; joint <= joints; ++joint) out << ',' << group << joint;
  out << '\n';
}

/// A cell a joint, empty where there is nothing to tell.
void writeJoints(std::ostream& out, const robot::Joints& values, Eigen::Index joints) {
  for (Eigen::Index joint = 0; joint < joints; ++joint) {
    out << ',';
    if (joint < values.size()) out << values[joint];
  }
}

void writeRow(std::ostream& out, const control::ServoState& state, Eigen::Index joints) {
  out << toNanoseconds(state.time) << ',' << id(state.permit) << ',' << id(state.stop) << ','
      << id(state.guard);
  for (const auto* group :
       {&state.measured.q_rad, &state.measured.v_rad_s, &state.commanded.q_rad, &state.commanded.v_rad_s,
        &state.commanded.a_rad_s2, &state.sent.q_rad, &state.sent.v_rad_s})
    writeJoints(out, *group, joints);
  out << '\n';
}

}  // namespace

Expected<void, std::string> writeBlackBox(const std::filesystem::path& file,
                                          std::span<const control::ServoState> states) {
  return writeWhole(file, [&](std::ostream& out) {
    const Eigen::Index joints = states.empty() ? 0 : states.back().measured.q_rad.size();
    writeHeader(out, joints);
    for (const auto& state : states) writeRow(out, state, joints);
  });
}

}  // namespace mirrorarm::station
