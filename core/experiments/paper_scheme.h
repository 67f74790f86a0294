#pragma once

#include "core/experiments/follow_run.h"

namespace mirrorarm::experiments {

/// The paper's control scheme (section 2.4) as a model, on the same arm with the same limits: every 40 ms the
/// newest pose is taken, a plan takes 20 ms, then a quintic leads from the commanded state to rest at the
/// goal; nothing is predicted. Camera, transfer and the arm's own delay are those of `run`, tracking takes
/// the paper's 9.42 ms. The error is the reason.
[[nodiscard]] Expected<std::vector<FollowMoment>, std::string> followAsThePaper(
    const FollowRunSettings& settings, const FollowRun& run);

}  // namespace mirrorarm::experiments
