#include "core/station/calibration_jobs.h"

#include <algorithm>
#include <utility>

#include "core/common/calendar.h"
#include "core/common/log.h"
#include "core/station/black_box_file.h"

namespace mirrorarm::station {
namespace {

void complain(const std::string& what) { log(LogLevel::kError, "calibration: " + what); }

/// The answer of work that failed in a way nobody foresaw: the job goes on as after a refusal.
ViewProposal failed(const ViewProposal&, const std::exception& failure) {
  complain(failure.what());
  return {};
}
SolveAnswer failed(const SolveAnswer&, const std::exception& failure) {
  return {nullptr, failure.what(), {}, {}};
}
WriteAnswer failed(const WriteAnswer&, const std::exception& failure) { return {{}, failure.what(), {}}; }

WriteAnswer write(CalibrationArchive& archive, const CalibrationOutcome& outcome,
                  std::span<const std::string> removed, std::span<const calibration::PosePair> pairs,
                  const std::filesystem::path& folder) {
  auto record = archive.accept(recordOf(outcome, isoUtcNow()), removed, pairs);
  if (!record) return {{}, record.error(), {}};
  auto in_force = calibration::CalibrationFolder(folder).read();
  if (!in_force) return {{}, describe(in_force.error()), {}};
  return {*record, {}, std::move(*in_force)};
}

}  // namespace

CalibrationJobs::CalibrationJobs(const CalibrationSettings& settings, JobRunner& runner)
    : shared_(std::make_shared<Shared>(settings)), runner_(runner) {}

void CalibrationJobs::begin() {
  ++job_;
  runner_.run([old = std::exchange(archive_, std::make_shared<CalibrationArchive>(
                                                 shared_->settings.folder))]() mutable { old.reset(); });
}

template <class Work>
void CalibrationJobs::ask(std::uint64_t version, Work work) {
  runner_.run([shared = shared_, job = job_, version, work = std::move(work)] {
    using Given = decltype(work(*shared));
    Answer answer{job, version, {}};
    try {
      answer.value = work(*shared);
    } catch (const std::exception& failure) {
      answer.value = failed(Given{}, failure);
    }
    const std::lock_guard lock(shared->mutex);
    shared->answers.push_back(std::move(answer));
  });
}

void CalibrationJobs::keepImages(std::string name, camera::StereoFrame frame) {
  runner_.run([archive = archive_, name = std::move(name), frame = std::move(frame)] {
    if (const auto kept = archive->keep(name, frame); !kept) complain(kept.error());
  });
}

void CalibrationJobs::propose(ViewQuestion question, std::uint64_t version) {
  ask(version,
      [question = std::move(question)](Shared& shared) { return proposeView(question, shared.settings); });
}

void CalibrationJobs::solve(SolveQuestion question, std::uint64_t version) {
  shared_->progress = 0.0;
  ask(version, [question = std::move(question)](Shared& shared) {
    return solveCalibration(question, shared.settings.drift_limits, shared.progress);
  });
}

void CalibrationJobs::accept(std::shared_ptr<const CalibrationOutcome> outcome,
                             std::vector<std::string> removed_views,
                             std::vector<calibration::PosePair> pairs) {
  ask(0, [archive = archive_, outcome = std::move(outcome), removed = std::move(removed_views),
          pairs = std::move(pairs)](Shared& shared) {
    return write(*archive, *outcome, removed, pairs, shared.settings.folder);
  });
}

// At once: jobs that wait are dropped when the calibration is left, and the robot rests anyway.
void CalibrationJobs::keepBlackBox(std::span<const control::ServoState> states, control::StopReason reason) {
  const auto& folder = shared_->settings.black_box_folder;
  if (folder.empty()) return;
  if (const auto written = writeBlackBox(blackBoxFile(folder, reason), states); !written)
    complain(written.error());
}

std::vector<CalibrationJobs::Answer> CalibrationJobs::takeAnswers() {
  std::vector<Answer> answers;
  {
    const std::lock_guard lock(shared_->mutex);
    answers.swap(shared_->answers);
  }
  std::erase_if(answers, [this](const Answer& answer) { return answer.job != job_; });
  return answers;
}

}  // namespace mirrorarm::station
