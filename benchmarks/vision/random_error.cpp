#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "benchmarks/statistics.h"
#include "benchmarks/vision/disc_trials.h"
#include "benchmarks/vision/error_chart.h"
#include "benchmarks/vision/suite.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kLeastRatio = 0.7;
constexpr double kBoundFactor = 1.15;

struct Case {
  double diameter_px;
  double snr;
  double most_px;  ///< goal; 0: kBoundFactor times the bound
};
constexpr std::array kCases{Case{7, 100, 0}, Case{10, 100, 0}, Case{16, 100, 0}, Case{24, 100, 0},
                            Case{10, 40, 0.013}};

std::string nameOf(const Case& each) {
  return "D " + shortNumber(each.diameter_px) + " px, SNR " + shortNumber(each.snr);
}

std::string missing(const MethodError& error, std::size_t trials) {
  const std::size_t lost = trials - static_cast<std::size_t>(error.found);
  return lost == 0 ? error.name : error.name + " (" + std::to_string(lost) + " lost)";
}

/// The default method's error is what is measured; the others stand beside it.
Row errorRow(const std::string& name, const std::vector<MethodError>& errors, std::size_t trials) {
  Row row;
  row.name = name;
  for (const MethodError& error : errors)
    (&error == &errors.front() ? row.measured : row.references)
        .push_back({missing(error, trials), error.rms_px, "px"});
  return row;
}

void addBounds(Row& row, const MeanBound& bound) {
  row.references.push_back({"CRLB formula", bound.formula_px, "px"});
  row.references.push_back({"CRLB, centre alone unknown", bound.numeric.centre_alone, "px"});
  row.references.push_back({"CRLB, 8 parameters", bound.numeric.blurred_ellipse, "px"});
  row.references.push_back({"CRLB, 10 with ramp", bound.numeric.with_ramp, "px"});
}

bool foundAll(const MethodError& error, std::size_t trials) {
  return static_cast<std::size_t>(error.found) == trials;
}

/// The default method is judged; our other methods stand beside it.
Row honestyRow(const std::string& name, const std::vector<MethodError>& errors) {
  const MethodError& judged = errors.front();
  const double mean = judged.mean_normalised_square.value_or(std::nan(""));
  const Interval band = chiSquareMeanBand(2, judged.found);
  Row row;
  row.name = "covariance, " + name;
  row.goal = "mean of e'C^-1 e from " + shortNumber(band.low) + " to " + shortNumber(band.high);
  row.measured = {{judged.name, mean, ""}};
  for (const MethodError& error : errors)
    if (&error != &judged && error.mean_normalised_square)
      row.references.push_back({error.name, *error.mean_normalised_square, ""});
  row.references.push_back({"trials", 1.0 * judged.found, ""});
  row.pass = band.holds(mean);
  return row;
}

void judge(Row& row, const Case& each, const MethodError& error, const MeanBound& bound, std::size_t trials) {
  const double least = std::min(bound.formula_px, bound.numeric.blurred_ellipse);
  const double most = each.most_px > 0.0 ? each.most_px : kBoundFactor * least;
  row.goal = "<= " + shortNumber(most) + " px" + (each.most_px > 0.0 ? "" : " (1.15 x CRLB)");
  row.measured.push_back({"/ CRLB", error.rms_px / least, ""});
  row.pass = foundAll(error, trials) && error.rms_px <= most;
}

Chart::Point pointOf(double diameter_px, double error_px) { return {diameter_px, error_px}; }

/// One curve a method and one for the bound.
void addToChart(Chart& chart, double diameter_px, const std::vector<MethodError>& errors,
                const MeanBound& bound) {
  for (const MethodError& error : errors) chart.add(error.name, pointOf(diameter_px, error.rms_px));
  chart.add("Cramer-Rao bound", pointOf(diameter_px, bound.numeric.blurred_ellipse));
}

/// `ramp` is what the reflectance gains from one end of the disc to the other, against its mean.
Row rampRow(const Run& run, double ramp) {
  constexpr double kDiameter_px = 10.0, kSnr = 100.0, kMost_px = 0.02;
  const auto stream = static_cast<std::uint64_t>(1000.0 * ramp);
  const auto trials = runDiscTrials(run.trials(2000, 60), kSnr, stream, [&](TrialRandom& random) {
    Disc disc = randomDisc(kDiameter_px, kLeastRatio, random);
    const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
    disc.slope = ramp / kDiameter_px * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    return disc;
  });
  const auto errors = errorsOf(trials);
  Row row = errorRow("D 10 px, SNR 100, " + shortNumber(100.0 * ramp) + " % from end to end", errors,
                     trials.size());
  row.goal = "<= " + shortNumber(kMost_px) + " px";
  row.pass = foundAll(errors.front(), trials.size()) && errors.front().rms_px <= kMost_px;
  addBounds(row, meanBoundOf(trials, kSnr));
  return row;
}

}  // namespace

void measureRandomError(Run& run) {
  const int count = run.trials(2000, 60);
  Chart chart("Random centre error per axis, SNR 100", "diameter of the disc [px]", "rms [px]");
  std::vector<Row> honesty;
  for (const Case& each : kCases) {
    const auto stream = static_cast<std::uint64_t>(each.diameter_px * 1000.0 + each.snr);
    const auto trials = runDiscTrials(count, each.snr, stream, [&](TrialRandom& random) {
      return randomDisc(each.diameter_px, kLeastRatio, random);
    });
    const auto errors = errorsOf(trials);
    const MeanBound bound = meanBoundOf(trials, each.snr);
    Row row = errorRow(nameOf(each), errors, trials.size());
    judge(row, each, errors.front(), bound, trials.size());
    addBounds(row, bound);
    run.report.rows.push_back(row);
    honesty.push_back(honestyRow(nameOf(each), errors));
    if (each.snr == 100.0) addToChart(chart, each.diameter_px, errors, bound);
  }
  run.report.rows.insert(run.report.rows.end(), honesty.begin(), honesty.end());
  chart.write(run.options.out / "random_error.png");
}

void measureRamp(Run& run) {
  for (const double ramp : {0.2, 0.4}) run.report.rows.push_back(rampRow(run, ramp));
}

}  // namespace mirrorarm::benchmarks::vision
