#include "core/records/sample_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>
#include <soci/soci.h>

namespace mirrorarm::records {
namespace {

using therapy::Sample;
using tracking::TrackStatus;

constexpr std::array<const char*, 4> kNumbers{"time_s", "rms_m", "sigma_t_m", "sigma_r_rad"};
constexpr std::array<const char*, 2> kKnowns{"force_share", "help_level"};
constexpr std::array<const char*, 3> kCounts{"training", "matched", "help_adapts"};
constexpr std::array<const char*, 4> kPoses{"ct", "bt", "be", "goal"};
constexpr std::array<const char*, 7> kPoseParts{"tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"};
constexpr std::array<const char*, 3> kJoints{"q_rad", "v_rad_s", "a_rad_s2"};
constexpr std::array<std::string_view, 3> kStatusNames{"tracked", "predicted", "lost"};

/// What follows a column's name, by the column's kind.
struct Suffixes {
  const char* number = "";
  const char* count = "";
  const char* text = "";
  const char* maybe = "";  // a number that may be missing
};

/// ", PREFIXname SUFFIX" for every column but the keys.
std::string columnList(const std::string& prefix = "", const Suffixes& suffixes = {}) {
  std::string list;
  const auto add = [&](const std::string& name, const char* suffix) {
    list += ", " + prefix + name + suffix;
  };
  for (const auto* number : kNumbers) add(number, suffixes.number);
  for (const auto* known : kKnowns) add(known, suffixes.maybe);
  for (const auto* count : kCounts) add(count, suffixes.count);
  add("status", suffixes.text);
  for (const auto* pose : kPoses)
    for (const auto* part : kPoseParts) add(std::string(pose) + "_" + part, suffixes.maybe);
  for (const auto* joints : kJoints) add(joints, suffixes.text);
  return list;
}

std::string jsonOf(const robot::Joints& joints) {
  if (!joints.allFinite()) throw std::runtime_error("a joint of a sample is not finite");
  return nlohmann::json(std::vector<double>(joints.begin(), joints.end())).dump();
}

robot::Joints jointsOf(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const bool good = json.is_array() && json.size() <= robot::kMaxJoints &&
                    std::ranges::all_of(json, [](const auto& value) { return value.is_number(); });
  if (!good) throw std::runtime_error("the joints of a sample are damaged");
  robot::Joints joints(static_cast<Eigen::Index>(json.size()));
  for (std::size_t i = 0; i < json.size(); ++i) joints[static_cast<Eigen::Index>(i)] = json[i].get<double>();
  return joints;
}

/// A pose as it lies in seven columns, all empty where there is no pose.
struct PoseCells {
  std::array<double, kPoseParts.size()> value{};
  std::array<soci::indicator, kPoseParts.size()> there{};

  void set(const RigidTransform& X, bool is_there) {
    if (is_there && !isRigid(X)) throw std::runtime_error("a pose of a sample is not rigid");
    there.fill(is_there ? soci::i_ok : soci::i_null);
    const Eigen::Vector3d p = X.translation();
    const Eigen::Quaterniond q = rotationOf(X);
    value = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
  }
  [[nodiscard]] RigidTransform pose() const {
    if (std::ranges::all_of(there, [](auto indicator) { return indicator == soci::i_null; }))
      return RigidTransform::Identity();
    const Eigen::Quaterniond q(value[6], value[3], value[4], value[5]);
    const bool good = std::ranges::all_of(there, [](auto indicator) { return indicator == soci::i_ok; }) &&
                      std::ranges::all_of(value, [](double number) { return std::isfinite(number); }) &&
                      std::abs(q.norm() - 1.0) < 1e-6;
    if (!good) throw std::runtime_error("a pose of a sample is damaged");
    return makeTransform(q, Eigen::Vector3d(value[0], value[1], value[2]));
  }
};

/// A number that may be missing, as it lies in its column.
struct KnownCell {
  double value = 0.0;
  soci::indicator there = soci::i_null;

  void set(const std::optional<double>& known) {
    if (known && !std::isfinite(*known)) throw std::runtime_error("a number is not finite");
    value = known.value_or(0.0);
    there = known ? soci::i_ok : soci::i_null;
  }
  [[nodiscard]] std::optional<double> known() const {
    return there == soci::i_ok ? std::optional(value) : std::nullopt;
  }
};

TrackStatus statusOf(std::string_view name) {
  const auto found = std::ranges::find(kStatusNames, name);
  if (found == kStatusNames.end()) throw std::runtime_error("the status of a sample is damaged");
  return static_cast<TrackStatus>(found - kStatusNames.begin());
}

/// One row, bound once to a statement and filled or read again and again.
struct SampleRow {
  double time_s = 0.0, rms_m = 0.0, sigma_t_m = 0.0, sigma_r_rad = 0.0;
  KnownCell force_share, help_level;
  int training = 0, matched = 0, help_adapts = 0;
  std::string status;
  std::array<PoseCells, kPoses.size()> poses;
  std::array<std::string, kJoints.size()> joints;

  void set(const Sample& sample) {
    if (!std::isfinite(sample.time_s + sample.rms_m + sample.sigma_t_m + sample.sigma_r_rad))
      throw std::runtime_error("a number of a sample is not finite");
    time_s = sample.time_s;
    rms_m = sample.rms_m;
    sigma_t_m = sample.sigma_t_m;
    sigma_r_rad = sample.sigma_r_rad;
    training = sample.training ? 1 : 0;
    matched = sample.matched;
    force_share.set(sample.force_share);
    help_level.set(sample.help_level);
    help_adapts = sample.help_adapts ? 1 : 0;
    status = kStatusNames.at(static_cast<std::size_t>(sample.status));
    const bool seen = sample.status != TrackStatus::kLost;
    poses[0].set(sample.X_CT, seen);
    poses[1].set(sample.X_BT, seen);
    poses[2].set(sample.X_BE, true);
    poses[3].set(sample.X_BE_goal, sample.training);
    joints = {jsonOf(sample.q_rad), jsonOf(sample.v_rad_s), jsonOf(sample.a_rad_s2)};
  }

  [[nodiscard]] Sample sample() const {
    Sample sample;
    sample.time_s = time_s;
    sample.rms_m = rms_m;
    sample.sigma_t_m = sigma_t_m;
    sample.sigma_r_rad = sigma_r_rad;
    sample.training = training != 0;
    sample.matched = matched;
    sample.force_share = force_share.known();
    sample.help_level = help_level.known();
    sample.help_adapts = help_adapts != 0;
    sample.status = statusOf(status);
    sample.X_CT = poses[0].pose();
    sample.X_BT = poses[1].pose();
    sample.X_BE = poses[2].pose();
    sample.X_BE_goal = poses[3].pose();
    sample.q_rad = jointsOf(joints[0]);
    sample.v_rad_s = jointsOf(joints[1]);
    sample.a_rad_s2 = jointsOf(joints[2]);
    return sample;
  }
};

/// Hands every cell, one that may be missing with its indicator, to `take` in the order of columnList().
template <class Take>
void eachCell(SampleRow& row, const Take& take) {
  for (double* number : {&row.time_s, &row.rms_m, &row.sigma_t_m, &row.sigma_r_rad}) take(*number);
  for (KnownCell* known : {&row.force_share, &row.help_level}) take(known->value, known->there);
  for (int* count : {&row.training, &row.matched, &row.help_adapts}) take(*count);
  take(row.status);
  for (auto& pose : row.poses)
    for (std::size_t i = 0; i < pose.value.size(); ++i) take(pose.value[i], pose.there[i]);
  for (auto& joints : row.joints) take(joints);
}

}  // namespace

std::string sampleTable() {
  return "create table sample (id integer primary key autoincrement, "
         "session_id integer not null references session (id)" +
         columnList("", {" real not null", " integer not null", " text not null", " real"}) + ")";
}

void insertSamples(soci::session& sql, std::int64_t session, std::span<const Sample> samples) {
  const long long id = session;
  SampleRow row;
  soci::statement insert(sql);
  insert.exchange(soci::use(id));
  eachCell(row, [&](auto&... cell) { insert.exchange(soci::use(cell...)); });
  insert.alloc();
  insert.prepare("insert into sample (session_id" + columnList() + ") values (:session_id" + columnList(":") +
                 ")");
  insert.define_and_bind();
  for (const auto& sample : samples) {
    row.set(sample);
    insert.execute(true);
  }
}

std::vector<Sample> selectSamples(soci::session& sql, std::int64_t session) {
  const long long id = session;
  SampleRow row;
  soci::statement select(sql);
  select.exchange(soci::use(id));
  eachCell(row, [&](auto&... cell) { select.exchange(soci::into(cell...)); });
  select.alloc();
  select.prepare("select " + columnList().substr(2) +
                 " from sample where session_id = :session_id order by id");
  select.define_and_bind();
  select.execute();
  std::vector<Sample> samples;
  while (select.fetch()) samples.push_back(row.sample());
  return samples;
}

}  // namespace mirrorarm::records
