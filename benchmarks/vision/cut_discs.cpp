#include <map>
#include <numbers>

#include "benchmarks/vision/disc_trials.h"
#include "benchmarks/vision/suite.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kLeastRatio = 0.7;
constexpr double kLeastShare = 0.1, kMostShare = 0.4;
constexpr double kGood_px = 0.15, kSilent_px = 0.3;

/// Counts of what the default method says about the discs of a case.
struct Fate {
  int trials = 0;
  int not_found = 0, refused_as_cut = 0, flagged = 0;
  int good = 0, fair = 0, silent = 0;  ///< not flagged: within 0.15 px, within 0.3 px, beyond
  double flagged_square_px2 = 0.0;
  std::map<product::Rejection, int> refused_otherwise;  ///< among those not found

  void add(const DiscTrial& trial);
  [[nodiscard]] double share(int count) const { return static_cast<double>(count) / trials; }
};

void Fate::add(const DiscTrial& trial) {
  ++trials;
  const Answer& answer = trial.answers.front();
  if (!answer) {
    const auto& reason = answer.error().reason;
    ++(reason == product::Rejection::kCut ? refused_as_cut : not_found);
    if (reason && reason != product::Rejection::kCut) ++refused_otherwise[*reason];
    return;
  }
  const double off_px = (answer->centre_px - trial.truth.centre_px).norm();
  if (answer->cut) {
    ++flagged;
    flagged_square_px2 += off_px * off_px;
  } else {
    ++(off_px <= kGood_px ? good : off_px <= kSilent_px ? fair : silent);
  }
}

Fate fateOf(const std::vector<DiscTrial>& trials) {
  Fate fate;
  for (const DiscTrial& trial : trials) fate.add(trial);
  return fate;
}

std::string nameOf(double diameter_px, double snr) {
  return "D " + shortNumber(diameter_px) + " px, SNR " + shortNumber(snr);
}

Row cutRow(const std::string& name, const std::vector<DiscTrial>& trials) {
  constexpr double kGoal = 0.99;
  const Fate fate = fateOf(trials);
  Row row;
  row.name = name + ", 10-40 % covered";
  row.goal = ">= 99 % flagged or within 0.15 px, none silently beyond 0.3 px";
  row.measured = {
      {"flagged", 100.0 * fate.share(fate.flagged), "%"},
      {"refused as cut", 100.0 * fate.share(fate.refused_as_cut), "%"},
      {"unflagged within 0.15 px", 100.0 * fate.share(fate.good), "%"},
      {"to 0.3 px", 100.0 * fate.share(fate.fair), "%"},
      {"silently beyond", 100.0 * fate.share(fate.silent), "%"},
      {"not found", 100.0 * fate.share(fate.not_found), "%"},
      {"rms per axis of the flagged", std::sqrt(0.5 * fate.flagged_square_px2 / fate.flagged), "px"}};
  for (const auto& [reason, count] : fate.refused_otherwise)
    row.references.push_back(
        {"refused as " + std::string(product::id(reason)), 100.0 * fate.share(count), "%"});
  for (const MethodError& error : errorsOf(trials))
    row.references.push_back({error.name, error.rms_px, "px"});
  row.pass = fate.silent == 0 && fate.share(fate.flagged + fate.refused_as_cut + fate.good) >= kGoal;
  return row;
}

Row wholeRow(const std::string& name, const std::vector<DiscTrial>& trials) {
  const Fate fate = fateOf(trials);
  Row row;
  row.name = name + ", nothing covered";
  row.measured = {{"falsely flagged", 100.0 * fate.share(fate.flagged), "%"},
                  {"falsely refused as cut", 100.0 * fate.share(fate.refused_as_cut), "%"},
                  {"not found", 100.0 * fate.share(fate.not_found), "%"},
                  {"trials", 1.0 * fate.trials, ""}};
  return row;
}

Disc randomCutDisc(double diameter_px, TrialRandom& random) {
  Disc disc = randomDisc(diameter_px, kLeastRatio, random);
  disc.cut = cutOfArea(random.uniform(kLeastShare, kMostShare), random.uniform(0.0, 2.0 * std::numbers::pi));
  return disc;
}

}  // namespace

void measureCutDiscs(Run& run) {
  const int count = run.trials(2000, 40);
  std::vector<Row> whole;
  for (const double snr : {100.0, 40.0})
    for (const double diameter_px : {10.0, 12.0, 16.0, 24.0}) {
      const auto stream = static_cast<std::uint64_t>(100000.0 + 1000.0 * diameter_px + snr);
      const auto cut = runDiscTrials(count, snr, stream,
                                     [&](TrialRandom& random) { return randomCutDisc(diameter_px, random); });
      run.report.rows.push_back(cutRow(nameOf(diameter_px, snr), cut));
      const auto makeWhole = [&](TrialRandom& random) {
        return randomDisc(diameter_px, kLeastRatio, random);
      };
      const auto uncut = runDiscTrials(count, snr, stream + 500, makeWhole, defaultEstimator);
      whole.push_back(wholeRow(nameOf(diameter_px, snr), uncut));
    }
  run.report.rows.insert(run.report.rows.end(), whole.begin(), whole.end());
}

}  // namespace mirrorarm::benchmarks::vision
