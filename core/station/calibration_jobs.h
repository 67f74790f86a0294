#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <variant>
#include <vector>

#include "core/station/calibration_archive.h"
#include "core/station/calibration_solver.h"
#include "core/station/job_runner.h"
#include "core/station/view_question.h"

namespace mirrorarm::station {

/// What became of a record.
struct WriteAnswer {
  std::string record;             ///< its name; empty: not written
  std::string refusal;            ///< why not
  calibration::InForce in_force;  ///< afterwards
};

/// The work of a calibration that takes longer than a stage's beat. Answers come back in the order of the
/// questions; each names the job (a count) that it belongs to. Control thread only.
class CalibrationJobs {
 public:
  using Value = std::variant<ViewProposal, SolveAnswer, WriteAnswer>;
  struct Answer {
    std::uint64_t job = 0;
    std::uint64_t version = 0;  ///< of the views asked about
    Value value;
  };

  CalibrationJobs(const CalibrationSettings& settings, JobRunner& runner);

  /// What comes now belongs to the next job; the one before is forgotten, with its images.
  void begin();
  [[nodiscard]] std::uint64_t job() const { return job_; }

  void keepImages(std::string name, camera::StereoFrame frame);
  void propose(ViewQuestion question, std::uint64_t version);
  void solve(SolveQuestion question, std::uint64_t version);
  void accept(std::shared_ptr<const CalibrationOutcome> outcome, std::vector<std::string> removed_views,
              std::vector<calibration::PosePair> pairs);
  void keepBlackBox(std::span<const control::ServoState> states, control::StopReason reason);

  /// Those of the present job that came since the last call.
  [[nodiscard]] std::vector<Answer> takeAnswers();
  /// Of the solving, 0..1.
  [[nodiscard]] double progress() const { return shared_->progress; }

 private:
  /// Outlives a job that is still running.
  struct Shared {
    explicit Shared(CalibrationSettings given) : settings(std::move(given)) {}
    const CalibrationSettings settings;
    std::atomic<double> progress{0.0};
    std::mutex mutex;
    std::vector<Answer> answers;  ///< guarded by mutex
  };
  template <class Work>
  void ask(std::uint64_t version, Work work);
  std::shared_ptr<Shared> shared_;
  JobRunner& runner_;
  std::shared_ptr<CalibrationArchive> archive_;
  std::uint64_t job_ = 0;
};

}  // namespace mirrorarm::station
