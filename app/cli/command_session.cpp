#include <iostream>
#include <memory>
#include <thread>

#include "app/cli/commands.h"
#include "app/cli/method_option.h"
#include "app/cli/pose_audit.h"
#include "app/cli/session_files.h"
#include "app/robot_option/robot_option.h"
#include "core/common/atomic_file.h"
#include "core/common/resources.h"
#include "core/records/store.h"
#include "core/station/bench_equipment.h"
#include "core/station/lockstep_station.h"
#include "core/station/session_script.h"
#include "core/station/station.h"

namespace mirrorarm::cli {
namespace {

constexpr Seconds kLookEvery{0.020};

struct Options {
  std::filesystem::path out;
  double seconds = 30.0;
  std::uint64_t seed = 1;
  std::string exercise = "reach";
  std::filesystem::path motion;
  std::string mapping = "follow";
  std::string lens = "kannala_brandt";
  vision::CentreMethod method = vision::FinderSettings{}.method;
  bool fast = false;
  app::RobotOption robot;
};

simulation::BenchSettings benchSettings(const Options& options) {
  simulation::BenchSettings bench;
  bench.resources = resourceFolder();
  bench.lens = *camera::lensModelOf(options.lens);
  bench.motion = options.motion;
  bench.seed = options.seed;
  bench.own_pace = !options.fast;
  const auto exercise = therapy::exerciseOf(options.exercise);
  if (!exercise) throw InputRefused("--exercise: there is none called '" + options.exercise + "'");
  bench.legs = station::legsOf(*exercise);
  return bench;
}

station::StationSettings stationSettings(const Options& options) {
  station::StationSettings settings;
  settings.store_file = options.out / "store.sqlite";
  settings.black_box_folder = options.out;
  settings.exercise = options.motion.empty() ? options.exercise : options.motion.filename().string();
  settings.planner.seed = options.seed;
  settings.finder.method = options.method;
  return settings;
}

/// Works the script until it is done; `advance` lets the time pass and says what time it is then.
template <class Advance>
void work(station::SessionScript& script, PoseAudit& audit, Advance advance) {
  for (;;) {
    const auto progress = script.step(advance());
    audit.look(script.seen());
    if (progress != station::SessionScript::Progress::kRunning) return;
  }
}

/// One session, in either pace; the station is gone, and so its record closed, when this returns.
struct Outcome {
  station::RecordState record;
  int stops = 0;
  int reteachings = 0;
  std::string failure;  ///< why it ended early; empty where it did not
};

Outcome outcomeOf(const station::SessionScript& script) {
  const auto& seen = script.seen();
  return {seen.record, script.stops(), seen.frame ? seen.frame->reteachings : 0, script.failure()};
}

Outcome runFast(simulation::Bench& bench, ManualTime& time, const Options& options,
                const station::ScriptSettings& settings, PoseAudit& audit) {
  station::LockstepStation station(station::equipmentOf(bench), stationSettings(options), time);
  station::SessionScript script(station, settings, [&](bool moving) { bench.setPatientMoving(moving); });
  work(script, audit, [&] {
    station.advanceTo(time.now() + toClock(kLookEvery));
    return time.now();
  });
  return outcomeOf(script);
}

Outcome runInRealTime(simulation::Bench& bench, const Options& options,
                      const station::ScriptSettings& settings, PoseAudit& audit) {
  station::Station station(station::equipmentOf(bench), stationSettings(options));
  station::SessionScript script(station, settings, [&](bool moving) { bench.setPatientMoving(moving); });
  work(script, audit, [] {
    std::this_thread::sleep_for(kLookEvery);
    return Clock::now();
  });
  return outcomeOf(script);
}

nlohmann::ordered_json resultOf(const Options& options, const Outcome& outcome, const PoseAudit& audit) {
  const auto& measures = outcome.record.measures;
  return {{"frames", measures.frames},
          {"tracked_share", measures.tracked_share},
          {"pose_error_mm", {{"rms", audit.rms_mm()}, {"p95", audit.p95_mm()}}},
          {"lag_ms", measures.lag_ms},
          {"gain", measures.gain},
          {"felt_error_mm", measures.felt_error_mm},
          {"shape_error_mm", measures.shape_error_mm},
          {"joint_speed_ratio", measures.joint_speed_ratio},
          {"joint_acceleration_ratio", measures.joint_acceleration_ratio},
          {"tool_speed_m_s", measures.tool_speed_m_s},
          {"repetitions", measures.repetitions},
          {"fit_rms_mm", measures.rms_mm},
          {"stops", outcome.stops},
          {"reteachings", outcome.reteachings},
          {"lost_samples", outcome.record.lost_samples},
          {"store", (options.out / "store.sqlite").string()},
          {"session", outcome.record.session}};
}

/// What only a robot that tells torques, or gives way to forces, has.
void addForceAndHelp(const therapy::SessionMeasures& measures, nlohmann::ordered_json& result) {
  if (measures.force_share) result["force_share"] = *measures.force_share;
  if (measures.help_level) result["help_level"] = *measures.help_level;
  if (measures.help_adapting_share) result["help_adapting_share"] = *measures.help_adapting_share;
}

void writeFiles(const Options& options, const Outcome& outcome, const RigidTransform& X_FE,
                const nlohmann::ordered_json& result) {
  auto store = records::Store::openExisting(options.out / "store.sqlite");
  if (!store) throw CommandFailed(store.error().reason);
  const auto samples = (*store)->samples(outcome.record.session);
  if (!samples) throw CommandFailed(samples.error().reason);
  orFail(writePoses(options.out / "poses.csv", *samples));
  orFail(writeRobot(options.out / "robot.csv", *samples, X_FE));
  orFail(writeWhole(options.out / "session.json", [&](std::ostream& out) { out << result.dump(2) << '\n'; }));
}

void session(const Options& options, Context& context) {
  station::ScriptSettings script;
  script.training = Seconds(options.seconds);
  script.mapping = *therapy::mappingOf(options.mapping);
  const auto bench_settings = benchSettings(options);
  if (options.fast && !options.robot.isSimulated())
    throw InputRefused("--fast: only the simulated robot keeps a clock of its own, not " +
                       options.robot.robot);
  ManualTime manual;
  const SteadyTime steady;
  if (options.fast) manual.set(TimePoint(toClock(Seconds(1.0))));
  const TimeSource& time = options.fast ? static_cast<const TimeSource&>(manual) : steady;
  auto robot = app::openBenchRobot(options.robot);
  if (!robot) throw CommandFailed(robot.error());
  const auto bench = orRefuse(simulation::Bench::make(bench_settings, time, std::move(*robot)));
  std::filesystem::create_directories(options.out);
  PoseAudit audit(*bench);
  const Outcome outcome = options.fast ? runFast(*bench, manual, options, script, audit)
                                       : runInRealTime(*bench, options, script, audit);
  const CommandFailed ended_early("the session ended early: " + outcome.failure);
  if (outcome.record.recording != station::Recording::kComplete)
    throw outcome.failure.empty()
        ? CommandFailed("the session's record is not complete: " + std::string(id(outcome.record.recording)))
        : ended_early;
  context.result = resultOf(options, outcome, audit);
  addForceAndHelp(outcome.record.measures, context.result);
  writeFiles(options, outcome, bench->X_FE(), context.result);
  if (!outcome.failure.empty()) throw ended_early;
  if (!context.json) std::cout << context.result.dump(2) << std::endl;
}

}  // namespace

void addSession(CLI::App& app, Context& context) {
  auto options = std::make_shared<Options>();
  CLI::App* command = addCommand(app, context, "session", "A whole session on the simulated bench, recorded",
                                 "mirrorarm-cli session --seconds 30 --exercise lift --out session --json");
  command->add_option("--out", options->out, "Folder for the record and the exports")->required();
  command->add_option("--seconds", options->seconds, "Length of the training")
      ->check(CLI::Range(1.0, 7200.0));
  command->add_option("--seed", options->seed, "Seed of everything random");
  command->add_option("--exercise", options->exercise, "reach, lift, side, circle or turn");
  command->add_option("--motion", options->motion, "A TRC file whose forearm markers carry the discs");
  command->add_option("--mapping", options->mapping, "follow or mirror")
      ->check(CLI::IsMember({"follow", "mirror"}));
  command->add_option("--lens", options->lens, "kannala_brandt or brown_conrady")
      ->check(CLI::IsMember({"kannala_brandt", "brown_conrady"}));
  addMethodOption(*command, options->method);
  app::addRobotOption(*command, options->robot);
  command->add_flag("--fast", options->fast, "As fast as it computes, on a clock of its own");
  command->callback([options, &context] { session(*options, context); });
}

}  // namespace mirrorarm::cli
