#include <algorithm>
#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/exposure_summary.h"
#include "app/cli/method_option.h"
#include "app/cli/timing.h"
#include "core/camera/image_file.h"
#include "core/common/time.h"
#include "core/devices/recording.h"
#include "core/vision/centres_file.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::cli {
namespace {

struct Options {
  std::vector<std::filesystem::path> inputs;
  bool dark = false;
  vision::CentreMethod method = vision::FinderSettings{}.method;
  std::filesystem::path out;
};

/// What was found in all images so far.
struct Findings {
  std::size_t images = 0;
  std::vector<vision::CentreRow> rows;
  std::array<int, vision::kRejectionCount> rejected{};
  std::vector<double> pair_ms;
  std::vector<ExposureSummary> exposures;  ///< a camera each, or an image

  void add(long long index, const std::string& camera, const vision::Detection& detection,
           ExposureSummary& exposure) {
    ++images;
    exposure.add(detection.exposure);
    for (const auto& marker : detection.markers) rows.push_back({index, camera, marker});
    for (std::size_t i = 0; i < rejected.size(); ++i) rejected[i] += detection.rejected[i];
  }
};

vision::FinderSettings settingsOf(const Options& options) {
  auto settings = options.dark ? vision::plateSettings() : vision::FinderSettings{};
  settings.method = options.method;
  return settings;
}

/// Both images of every frame, as the workstation looks at them.
Findings detectInRecording(const std::filesystem::path& folder, const vision::FinderSettings& settings) {
  const auto recording = orRefuse(devices::Recording::open(folder));
  vision::StereoVision vision(recording.rig(), settings, vision::MatcherSettings{});
  Findings findings;
  findings.exposures = {ExposureSummary("left"), ExposureSummary("right")};
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const auto frame = orRefuse(recording.frame(i));
    const TimePoint begin = Clock::now();
    const auto& observation = vision.observe(frame);
    findings.pair_ms.push_back(1e3 * secondsBetween(begin, Clock::now()));
    findings.add(recording.index(i), "left", observation.left, findings.exposures[0]);
    findings.add(recording.index(i), "right", observation.right, findings.exposures[1]);
  }
  return findings;
}

/// Single images without a rig, one after the other; a pair is two of them.
Findings detectInImages(const std::vector<std::filesystem::path>& files,
                        const vision::FinderSettings& settings) {
  vision::MarkerFinder finder(settings);
  Findings findings;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto image = orRefuse(camera::readImage(files[i]));
    const TimePoint begin = Clock::now();
    const auto& detection = finder.find(image.view());
    findings.pair_ms.push_back(2e3 * secondsBetween(begin, Clock::now()));
    auto& exposure = findings.exposures.emplace_back(files[i].filename().string());
    findings.add(static_cast<long long>(i), exposure.camera(), detection, exposure);
  }
  return findings;
}

nlohmann::ordered_json countsOf(const std::array<int, vision::kRejectionCount>& rejected) {
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < rejected.size(); ++i)
    if (rejected[i] > 0) counts[std::string(id(static_cast<vision::Rejection>(i)))] = rejected[i];
  return counts;
}

nlohmann::ordered_json exposuresOf(const std::vector<ExposureSummary>& summaries) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& summary : summaries) list.push_back(summary.json());
  return list;
}

void detect(const Options& options, Context& context) {
  const bool recording = options.inputs.size() == 1 && std::filesystem::is_directory(options.inputs[0]);
  const Findings findings = recording ? detectInRecording(options.inputs[0], settingsOf(options))
                                      : detectInImages(options.inputs, settingsOf(options));
  orFail(vision::writeCentres(options.out, findings.rows));
  const auto cut = std::count_if(findings.rows.begin(), findings.rows.end(),
                                 [](const vision::CentreRow& row) { return row.marker.cut; });
  context.result = {{"method", std::string(id(options.method))},
                    {"images", findings.images},
                    {"discs", findings.rows.size()},
                    {"cut", cut},
                    {"rejected", countsOf(findings.rejected)},
                    {"exposure", exposuresOf(findings.exposures)},
                    {"ms_per_pair", medianAndP99(findings.pair_ms)}};
  if (context.json) return;
  std::cout << findings.rows.size() << " discs in " << findings.images << " images, centres in "
            << options.out.string() << "\n";
}

}  // namespace

void addDetect(CLI::App& app, Context& context) {
  CLI::App* command = addCommand(app, context, "detect", "Find discs in a recording or in single images",
                                 "mirrorarm-cli detect --dark plate1.png plate2.png --out centres.csv");
  const auto options = std::make_shared<Options>();
  command->add_option("REC", options->inputs, "Folder of a recording, or images")->required();
  command->add_flag("--dark", options->dark, "Dark dots on bright ground, as on calibration plates");
  addMethodOption(*command, options->method);
  command->add_option("--out", options->out, "Table of centres to write")->required();
  command->callback([options, &context] { detect(*options, context); });
}

}  // namespace mirrorarm::cli
