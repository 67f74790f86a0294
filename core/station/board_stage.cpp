#include "core/station/board_stage.h"

#include "core/calibration/board_finder.h"
#include "core/calibration/board_pose.h"

namespace mirrorarm::station {

BoardReport BoardStage::process(const camera::StereoFrame& frame) {
  takeOrders();
  auto seen = std::make_shared<BoardFrame>();
  seen->frame = frame;
  if (watch_ && watch_->board) {
    const auto start = Clock::now();
    find(*seen);
    seen->finding_ms = 1e3 * secondsBetween(start, Clock::now());
    judge(*seen);
    if (watch_->rig) {
      if (const auto pose = calibration::poseBoard(*watch_->rig, *watch_->board, seen->view))
        seen->X_CM = pose->X_CM;
    }
  }
  return {std::move(seen), watch_ ? watch_->version : 0};
}

void BoardStage::takeOrders() {
  const auto* order = orders_.take();
  if (order == nullptr) return;
  const bool same_job = watch_ && watch_->job == (*order)->job;
  watch_ = *order;
  if (same_job) return;
  rule_.reset();
  last_left_.clear();
}

// A board that looks alike after a turn is numbered as in the frame before, and in the right image as in the
// left one.
void BoardStage::find(BoardFrame& seen) {
  const auto& board = *watch_->board;
  const auto left = calibration::findBoard(seen.frame.left.view(), board);
  const auto right = calibration::findBoard(seen.frame.right.view(), board);
  const auto larger = calibration::BoardMiss::kLargerBoard;
  seen.larger_board = (!left && left.error() == larger) || (!right && right.error() == larger);
  if (left) {
    seen.view.seen[0] = last_left_.empty() ? *left : calibration::orderedLike(last_left_, *left, board);
    last_left_ = seen.view.seen[0];
  }
  if (right) seen.view.seen[1] = left ? calibration::orderedLike(last_left_, *right, board) : *right;
}

void BoardStage::judge(BoardFrame& seen) {
  if (!rule_) {
    const auto& image = seen.frame.left;
    rule_.emplace(*watch_->board, calibration::ImageSize{image.width(), image.height()}, true, settings_);
  }
  seen.verdict = rule_->judge(seen.view, watch_->taken);
}

}  // namespace mirrorarm::station
