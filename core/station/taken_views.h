#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/station/calibration_snapshot.h"

namespace mirrorarm::station {

/// The views of a job, those that were removed again, and which state of the list this is. One thread.
class TakenViews {
 public:
  using List = std::vector<TakenView>;

  void clear();
  /// Names it, one after the other: "01", "02"; no name comes twice in a job.
  void add(TakenView view);
  /// False where there is no such view.
  [[nodiscard]] bool remove(std::size_t index);
  /// Puts the view removed last back to its place; false where there is none.
  [[nodiscard]] bool undoRemove();
  /// The same views with what solving found out about them.
  void setFindings(List views);

  [[nodiscard]] bool canUndo() const { return !removed_.empty(); }
  [[nodiscard]] std::size_t size() const { return views_->size(); }
  /// Never changes; the next state is another list.
  [[nodiscard]] const std::shared_ptr<const List>& list() const { return views_; }
  /// Rises whenever views come or go.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] std::vector<std::string> removedNames() const;

 private:
  struct Removed {
    std::size_t index = 0;
    TakenView view;
  };
  void replace(List views);
  std::shared_ptr<const List> views_ = std::make_shared<const List>();
  std::vector<Removed> removed_;
  std::size_t named_ = 0;
  std::uint64_t version_ = 0;
};

/// Their sightings alone.
[[nodiscard]] std::vector<calibration::BoardView> boardViewsOf(const TakenViews::List& views);

}  // namespace mirrorarm::station
