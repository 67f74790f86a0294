#pragma once

#include <vector>

#include "core/simulation/bench.h"
#include "core/station/snapshot.h"

namespace mirrorarm::cli {

/// Holds the tracked poses of a simulated session against the truth: the best rigid fit of the taught model
/// to the true positions of its discs.
class PoseAudit {
 public:
  explicit PoseAudit(const simulation::Bench& bench) : bench_(bench) {}

  /// Looks at a snapshot; frames that were looked at before, and those without a tracked target, are passed
  /// over.
  void look(const station::Snapshot& snapshot);

  /// Distances between tracked and true target origin [mm].
  [[nodiscard]] double rms_mm() const;
  [[nodiscard]] double p95_mm() const;
  [[nodiscard]] std::size_t size() const { return errors_mm_.size(); }

 private:
  const simulation::Bench& bench_;
  std::uint64_t next_sequence_ = 0;
  std::vector<double> errors_mm_;
};

}  // namespace mirrorarm::cli
