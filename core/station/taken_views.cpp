#include "core/station/taken_views.h"

#include <algorithm>
#include <cstdio>

namespace mirrorarm::station {
namespace {

std::string nameOf(std::size_t number) {
  char text[24];
  std::snprintf(text, sizeof text, "%02zu", number);
  return text;
}

}  // namespace

void TakenViews::replace(List views) {
  views_ = std::make_shared<const List>(std::move(views));
  ++version_;
}

void TakenViews::clear() {
  removed_.clear();
  named_ = 0;
  replace({});
}

void TakenViews::add(TakenView view) {
  view.name = view.view.name = nameOf(++named_);
  List views = *views_;
  views.push_back(std::move(view));
  replace(std::move(views));
}

bool TakenViews::remove(std::size_t index) {
  if (index >= views_->size()) return false;
  List views = *views_;
  removed_.push_back({index, views[index]});
  views.erase(views.begin() + static_cast<std::ptrdiff_t>(index));
  replace(std::move(views));
  return true;
}

bool TakenViews::undoRemove() {
  if (removed_.empty()) return false;
  List views = *views_;
  const auto at = std::min(removed_.back().index, views.size());
  views.insert(views.begin() + static_cast<std::ptrdiff_t>(at), removed_.back().view);
  removed_.pop_back();
  replace(std::move(views));
  return true;
}

void TakenViews::setFindings(List views) { views_ = std::make_shared<const List>(std::move(views)); }

std::vector<std::string> TakenViews::removedNames() const {
  std::vector<std::string> names;
  for (const auto& removed : removed_) names.push_back(removed.view.name);
  return names;
}

std::vector<calibration::BoardView> boardViewsOf(const TakenViews::List& views) {
  std::vector<calibration::BoardView> board_views;
  board_views.reserve(views.size());
  for (const auto& taken : views) board_views.push_back(taken.view);
  return board_views;
}

}  // namespace mirrorarm::station
