#include "core/station/black_box_file.h"

#include <array>
#include <charconv>

#include "core/common/atomic_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::station {
namespace {

/// A row of cells. Ten thousand rows of fifty numbers are written at a stop: printf and streams take seconds
/// for them.
class Row {
 public:
  void clear() { text_.clear(); }
  void add(std::string_view word) {
    separate();
    text_ += word;
  }
  template <class Number>
  void add(Number number) {
    separate();
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
    text_.append(digits.begin(), end);
  }
  /// A cell a joint, empty where there is nothing to tell.
  void addJoints(const robot::Joints& values, Eigen::Index joints) {
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      if (joint < values.size())
        add(values[joint]);
      else
        add(std::string_view());
    }
  }
  void writeTo(std::ostream& out) {
    text_ += '\n';
    out.write(text_.data(), static_cast<std::streamsize>(text_.size()));
  }

 private:
  void separate() {
    if (!text_.empty()) text_ += ',';
  }
  std::string text_;
};

constexpr std::string_view kPlainColumns =
    "time_ns,permit,stop,category,lasting,guard,refused,enabling,guard_joint,guard_part,guard_thing,soft_"
    "start,frame_age_s,target_age_s,"
    "decision_age_s,robot_age_s,force_x_n,force_y_n,force_z_n,force_share,assist_level";

constexpr std::array kJointColumns = {"measured_q",  "measured_v",  "external_torque", "commanded_q",
                                      "commanded_v", "commanded_a", "sent_q",          "sent_v"};

void writeHeader(std::ostream& out, Eigen::Index joints) {
  out << kPlainColumns;
  for (const char* group : kJointColumns)
    for (Eigen::Index joint = 1; joint <= joints; ++joint) out << ',' << group << joint;
  out << '\n';
}

/// Which joint, or what meets what, where the guard tells of it.
void addGuarded(Row& row, const control::ServoState& state) {
  const auto& near = state.guard_contact;
  if (state.guard_joint >= 0)
    row.add(state.guard_joint + 1);
  else
    row.add(std::string_view());
  row.add(near ? id(near->part) : std::string_view());
  row.add(!near ? std::string_view() : near->obstacle ? id(*near->obstacle) : "arm");
}

void addPlain(Row& row, const control::ServoState& state) {
  row.add(toNanoseconds(state.time));
  for (const auto word : {id(state.permit), id(state.stop), id(state.category), id(state.lasting),
                          id(state.guard), id(state.refused), id(state.enabling)})
    row.add(word);
  addGuarded(row, state);
  row.add(state.soft_start);
  for (const double age_s :
       {state.ages.frame_s, state.ages.target_s, state.ages.decision_s, state.ages.robot_s})
    row.add(age_s);
  for (const double newton : state.assist.force.force_B_n) row.add(newton);
  row.add(state.assist.force.limit_share);
  row.add(state.assist.level);
}

void addJoints(Row& row, const control::ServoState& state, Eigen::Index joints) {
  for (const auto* group :
       {&state.measured.q_rad, &state.measured.v_rad_s, &state.measured.external_torque_nm,
        &state.commanded.q_rad, &state.commanded.v_rad_s, &state.commanded.a_rad_s2, &state.sent.q_rad,
        &state.sent.v_rad_s})
    row.addJoints(*group, joints);
}

}  // namespace

std::filesystem::path blackBoxFile(const std::filesystem::path& folder, control::StopReason reason) {
  const std::string stem = "stop-" + isoUtcNow() + "-" + std::string(id(reason));
  auto file = folder / (stem + ".csv");
  for (int copy = 2; std::filesystem::exists(file); ++copy)
    file = folder / (stem + "-" + std::to_string(copy) + ".csv");
  return file;
}

Expected<void, std::string> writeBlackBox(const std::filesystem::path& file,
                                          std::span<const control::ServoState> states) {
  return writeWhole(file, [&](std::ostream& out) {
    const Eigen::Index joints = states.empty() ? 0 : states.back().measured.q_rad.size();
    writeHeader(out, joints);
    Row row;
    for (const auto& state : states) {
      row.clear();
      addPlain(row, state);
      addJoints(row, state, joints);
      row.writeTo(out);
    }
  });
}

}  // namespace mirrorarm::station
