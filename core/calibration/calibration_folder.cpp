#include "core/calibration/calibration_folder.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "core/camera/rig_file.h"
#include "core/common/atomic_file.h"
#include "core/common/calendar.h"
#include "core/common/yaml.h"

namespace mirrorarm::calibration {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFormat = "mirrorarm/in-force/1";
constexpr std::array<std::string_view, kCalibrationKindCount> kKinds = {"rig", "hand_eye", "clock", "drift"};
constexpr int kMostInOneSecond = 1000;

/// Names of the records in force, empty where there is none.
struct Names {
  std::array<std::string, kCalibrationKindCount> by_kind;
  [[nodiscard]] const std::string& of(CalibrationKind kind) const {
    return by_kind[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] std::string& of(CalibrationKind kind) { return by_kind[static_cast<std::size_t>(kind)]; }
};

fs::path listFile(const fs::path& folder) { return folder / "in_force.yaml"; }

std::string fileName(CalibrationKind kind) { return std::string(id(kind)) + ".yaml"; }

Names namesOf(const YamlNode& root) {
  root.allowOnly({"format", kKinds[0], kKinds[1], kKinds[2], kKinds[3]});
  Names names;
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    if (!root.has(kKinds[kind])) continue;
    auto& name = names.by_kind[kind];
    name = root[kKinds[kind]].text();
    if (name.empty() || name.find_first_of("/\\") != std::string::npos || name == "..")
      root[kKinds[kind]].refuse("is not the name of a record");
  }
  return names;
}

FromFile<Names> readNames(const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(listFile(folder), failed) && !failed) return Names{};
  return readYaml(listFile(folder), kFormat, namesOf);
}

Expected<void, std::string> writeNames(const fs::path& folder, const Names& names) {
  return writeWhole(listFile(folder), [&](std::ostream& out) {
    out << "format: " << kFormat << '\n';
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
      if (!names.by_kind[kind].empty()) out << kKinds[kind] << ": \"" << names.by_kind[kind] << "\"\n";
  });
}

template <class Record, class Read>
FromFile<void> readInto(std::optional<Record>& record, const Read& read, const fs::path& folder,
                        CalibrationKind kind, const Names& names) {
  if (names.of(kind).empty()) return {};
  auto value = read(folder / "records" / names.of(kind) / fileName(kind));
  if (!value) return unexpected(value.error());
  record = std::move(*value);
  return {};
}

Expected<void, std::string> write(const fs::path& file, const CalibrationRecord& record) {
  struct Writer {
    const fs::path& file;
    auto operator()(const camera::StereoRig& rig) const { return camera::writeRig(file, rig); }
    auto operator()(const HandEye& hand_eye) const { return writeHandEye(file, hand_eye); }
    auto operator()(const ClockRecord& clock) const { return writeClockRecord(file, clock); }
    auto operator()(const DriftRecord& drift) const { return writeDriftRecord(file, drift); }
  };
  return std::visit(Writer{file}, record);
}

/// Date and time without colons, which not every file system takes.
std::string stamp() {
  std::string text = isoUtcNow();
  std::erase(text, ':');
  return text;
}

/// A path in `parent` that is not there yet.
fs::path freePath(const fs::path& parent, const std::string& name) {
  std::error_code failed;
  fs::path path = parent / name;
  for (int i = 2; fs::exists(path, failed) && i < kMostInOneSecond; ++i)
    path = parent / (name + "-" + std::to_string(i));
  return path;
}

}  // namespace

std::string_view id(CalibrationKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

FromFile<InForce> CalibrationFolder::read() const {
  const auto names = readNames(folder_);
  if (!names) return unexpected(names.error());
  InForce in_force;
  for (const auto& done :
       {readInto(in_force.rig, camera::readRig, folder_, CalibrationKind::kRig, *names),
        readInto(in_force.hand_eye, readHandEye, folder_, CalibrationKind::kHandEye, *names),
        readInto(in_force.clock, readClockRecord, folder_, CalibrationKind::kClock, *names),
        readInto(in_force.drift, readDriftRecord, folder_, CalibrationKind::kDrift, *names)})
    if (!done) return unexpected(done.error());
  return in_force;
}

Expected<fs::path, std::string> CalibrationFolder::makeWorkFolder() const {
  std::error_code failed;
  fs::create_directories(folder_ / "work", failed);
  const auto path = freePath(folder_ / "work", stamp());
  if (!failed) fs::create_directory(path, failed);
  if (failed) return unexpected(path.string() + ": " + failed.message());
  return path;
}

Expected<std::string, std::string> CalibrationFolder::accept(const CalibrationRecord& record,
                                                             const fs::path& work_folder) const {
  auto names = readNames(folder_);
  if (!names) return unexpected(describe(names.error()));
  const auto work = work_folder.empty() ? makeWorkFolder() : Expected<fs::path, std::string>(work_folder);
  if (!work) return unexpected(work.error());
  const auto kind = static_cast<CalibrationKind>(record.index());
  if (const auto written = write(*work / fileName(kind), record); !written)
    return unexpected(written.error());
  std::error_code failed;
  fs::create_directories(folder_ / "records", failed);
  const auto place = freePath(folder_ / "records", stamp() + "-" + std::string(id(kind)));
  if (!failed) fs::rename(*work, place, failed);
  if (failed) return unexpected(place.string() + ": " + failed.message());
  names->of(kind) = place.filename().string();
  using enum CalibrationKind;
  if (kind == kRig) names->of(kHandEye).clear();
  if (kind == kRig || kind == kHandEye) names->of(kDrift).clear();
  if (const auto listed = writeNames(folder_, *names); !listed) return unexpected(listed.error());
  return place.filename().string();
}

}  // namespace mirrorarm::calibration
