#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/robot/fri_line.h"
#include "benchmarks/robot/suite.h"
#include "benchmarks/statistics.h"

namespace mirrorarm::benchmarks::robot {
namespace {

constexpr double kRest_rad = 2e-4;  // what encoders and drives still do after a stop
constexpr int kTries = 3;           // a pause of the machine may come before the fault does
constexpr double kFaultAt_s = 2.0;

double number(std::uint64_t count) { return static_cast<double>(count); }

double largest(const std::vector<double>& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : *std::max_element(values.begin(), values.end());
}

std::vector<Figure> spread(const std::string& name, const std::vector<double>& values_us) {
  return {{name + " median", quantile(values_us, 0.5), "us"},
          {name + " p99.9", quantile(values_us, 0.999), "us"},
          {name + " longest", largest(values_us), "us"}};
}

void addEndurance(Run& run) {
  const Seconds duration(run.trials(600, 5));
  const FriRun result = runFriLine({.duration = duration, .resume = true});
  const double minutes = duration.count() / 60.0;
  run.report.rows.push_back(
      {"",
       "answers missed in " + shortNumber(minutes) + " minutes at 1 ms, the servo loop in motion",
       "0 by our fault",
       {{"ours, unanswered", number(result.missed.unanswered), ""},
        {"ours, computed too long", number(result.missed.computed), ""},
        {"the machine's", number(result.missed.machine), ""},
        {"cycles", number(result.cycles), ""}},
       {{"beats the controller's thread slept through", number(result.skipped_beats), ""}},
       result.missed.ours() == 0 && result.travelled_rad > 0.0});
  auto delays = spread("answer", result.answer_delay_us);
  for (auto& figure : spread("computing", result.computing_us)) delays.push_back(figure);
  run.report.rows.push_back({"",
                             "from a datagram's arrival to our answer; processor time of a cycle",
                             "",
                             delays,
                             spread("idle thread wakes late", result.pauses_us),
                             {}});
  run.report.rows.push_back(
      {"",
       "stops on the way, each reset from rest",
       "",
       {{"stops", number(result.stops.size()), ""}, {"travelled", result.travelled_rad, "rad"}},
       {},
       {}});
}

/// A fault and whether the line bridges it.
struct Injected {
  const char* fault;
  bool bridged;
};

/// The run with a fault; again where a pause of the machine stopped the arm before.
FriRun inject(const Injected& injected) {
  const auto fault = peers::friFaultOf(injected.fault);
  FriRun result;
  for (std::uint64_t attempt = 0; attempt < kTries; ++attempt) {
    result = runFriLine({.duration = Seconds(kFaultAt_s + 2.0), .faults = {*fault}, .seed = kSeed + attempt});
    const bool too_early = !result.stops.empty() && result.first_stop_s < fault->from_s;
    if (!too_early && (!injected.bridged || result.stops.empty())) break;
  }
  return result;
}

void addFault(Run& run, const Injected& injected) {
  const FriRun result = inject(injected);
  const bool stopped = !result.stops.empty();
  const std::string reason = stopped ? std::string(id(result.stops.front())) : "bridged";
  const bool at_rest = stopped && result.rest_s > 0.0 && !result.driving && result.creep_rad < kRest_rad;
  const bool as_wanted =
      injected.bridged ? !stopped && result.driving : at_rest && result.fall != devices::FriFall::kNone;
  run.report.rows.push_back(
      {"",
       std::string(injected.fault) + ": " + reason + " (" + std::string(id(result.fall)) + ")",
       injected.bridged ? "goes on" : "rest and a reason",
       {{"rest after", stopped ? result.rest_s : std::nan(""), "s"},
        {"moved afterwards", stopped ? result.creep_rad : std::nan(""), "rad"}},
       {},
       as_wanted});
}

}  // namespace

void measureFri(Run& run) {
  addEndurance(run);
  const std::vector<Injected> all{{"silence@2+0.3", false},
                                  {"drive_error@2+0.5", false},
                                  {"lost@2+0.001", true},
                                  {"lost@2+0.01", false},
                                  {"late@2+0.2", false},
                                  {"duplicated@2", true},
                                  {"reordered:0.005@2", true},
                                  {"short@2+0.01", false},
                                  {"long@2+0.01", false},
                                  {"garbled@2+0.01", false},
                                  {"wrong_id@2+0.01", false},
                                  {"nan@2+0.01", false},
                                  {"poor_quality@2+0.5", false},
                                  {"start_pose", false},
                                  {"answer-lost@2+0.01", false},
                                  {"answer-late@2+0.2", false},
                                  {"answer-wrong_id@2+0.01", false},
                                  {"answer-nan@2+0.01", false},
                                  {"answer-duplicated@2", true}};
  const auto count = static_cast<std::size_t>(run.trials(static_cast<int>(all.size()), 2));
  for (std::size_t i = 0; i < count; ++i) addFault(run, all[i]);
}

}  // namespace mirrorarm::benchmarks::robot
