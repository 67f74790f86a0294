#include "ui/panels/robot_panel.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include "ui/panels/help_bars.h"
#include "ui/panels/help_choice.h"
#include "ui/panels/joint_bars.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

constexpr int kSpacing_px = 4;
constexpr int kMotion_px = 130;  // for the longest of its words

}  // namespace

RobotPanel::RobotPanel(HelpPresenter& help, QWidget* parent)
    : QWidget(parent),
      motion_(makeText("status")),
      help_(new HelpBars),
      joints_(new JointBars),
      tool_speed_(new Figure(tr("Tool speed"))),
      lag_(new Figure(tr("Delay"))),
      way_(new Figure(tr("Last goal"))),
      guard_(new Figure(tr("Limit met"))) {
  setObjectName(QStringLiteral("robotPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* card = makeCard(QStringLiteral("robotCard"));
  column->addWidget(card);
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  inside->setSpacing(kSpacing_px);
  auto* top = new QHBoxLayout;
  top->addWidget(makeText("heading", tr("Robot")));
  top->addStretch();
  top->addWidget(motion_);
  motion_->setMinimumWidth(kMotion_px);
  motion_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  inside->addLayout(top);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->addWidget(tool_speed_, 0, 0);
  grid->addWidget(lag_, 0, 1);
  grid->addWidget(way_, 1, 0);
  grid->addWidget(guard_, 1, 1);
  for (int i = 0; i < 2; ++i) grid->setColumnStretch(i, 1);
  inside->addLayout(grid);
  inside->addWidget(help_);
  inside->addWidget(new HelpChoice(help));
  inside->addWidget(joints_);
}

void RobotPanel::setTheme(const Theme& theme) {
  help_->setTheme(theme);
  joints_->setTheme(theme);
}

void RobotPanel::show(const RobotFigures& figures) {
  motion_->setText(figures.motion);
  help_->setFigures(figures);
  joints_->setJoints(figures.joints);
  tool_speed_->setValue(tr("%1 mm/s").arg(figures.tool_speed_m_s * 1e3, 0, 'f', 0));
  lag_->setValue(figures.lag);
  way_->setValue(figures.way);
  guard_->setValue(figures.guard);
}

}  // namespace mirrorarm::ui
