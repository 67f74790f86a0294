#include "ui/model/help_presenter.h"

#include <algorithm>
#include <cmath>

#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

constexpr double kSteps = 10.0;     // from no help to all
constexpr double kSameStep = 1e-6;  // a level this near a step is on it

double atStep(double step) { return std::clamp(step, 0.0, kSteps) / kSteps; }

}  // namespace

HelpPresenter::HelpPresenter(station::StationPort& port, QObject* parent) : QObject(parent), port_(port) {
  state_ = stateOf();
}

HelpState HelpPresenter::stateOf() const {
  HelpState next;
  next.can_change = given_.gives_way;
  next.adapts = given_.gives_way && wanted_.adapts;
  const bool fixed = given_.gives_way && !wanted_.adapts;
  next.can_lessen = fixed && wanted_.level > 0.0;
  next.can_raise = fixed && wanted_.level < 1.0;
  next.level = fixed ? tr("%1 %").arg(100.0 * wanted_.level, 0, 'f', 0) : QStringLiteral("–");
  if (!given_.gives_way) next.reason = tr("the robot is stiff");
  return next;
}

void HelpPresenter::show(const station::Snapshot& snapshot) {
  wanted_ = snapshot.control.help;
  given_ = snapshot.control.servo.assist;
  HelpState next = stateOf();
  if (next == state_) return;
  state_ = std::move(next);
  emit stateChanged(state_);
}

void HelpPresenter::setAdapts(bool on) {
  ask({on, on ? wanted_.level : atStep(std::round(kSteps * given_.level))});
}

void HelpPresenter::lessen() { ask({false, atStep(std::ceil(kSteps * wanted_.level - kSameStep) - 1.0)}); }

void HelpPresenter::raise() { ask({false, atStep(std::floor(kSteps * wanted_.level + kSameStep) + 1.0)}); }

void HelpPresenter::ask(const control::Help& help) {
  const auto answer = port_.changeHelp(help);
  if (answer != station::Answer::kAccepted) emit refused(words(answer));
}

}  // namespace mirrorarm::ui
