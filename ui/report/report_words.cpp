#include "ui/report/report_words.h"

#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

namespace mirrorarm::ui {
namespace {

class Report {
  Q_DECLARE_TR_FUNCTIONS(Report)
};

constexpr double kPaperLag_ms = 318.7;

QString lookedUp(const std::map<std::string, QString>& words, const std::string& id) {
  const auto found = words.find(id);
  return found == words.end() ? QString::fromStdString(id) : found->second;
}

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

QString dash() { return QStringLiteral("\u2013"); }

QString calendarTime(const std::string& iso) {
  const auto moment = QDateTime::fromString(QString::fromStdString(iso), Qt::ISODate).toLocalTime();
  if (!moment.isValid()) return QString::fromStdString(iso);
  return QLocale().toString(moment.date(), QLocale::LongFormat) + QStringLiteral(", ") +
         QLocale().toString(moment.time(), QStringLiteral("HH:mm")) + ' ' + moment.timeZoneAbbreviation();
}

QString endWords(const ReportContents& contents) {
  return contents.is_cut_off ? Report::tr("Cut off; recorded up to there")
                             : eventWords(contents.session.end_reason);
}

KeyFigure lagFigure(const therapy::SessionMeasures& measures) {
  const auto paper = Report::tr("paper: %1 ms").arg(number(kPaperLag_ms, 1));
  if (measures.lag_ms == 0.0)
    return {Report::tr("Lag of the robot"), dash(), {}, Report::tr("not determinable")};
  return {Report::tr("Lag of the robot"), number(measures.lag_ms, 0), Report::tr("ms"), paper};
}

KeyFigure ratioFigure(const QString& label, double ratio) {
  if (ratio == 0.0) return {label, dash(), {}, Report::tr("not determinable")};
  return {label, number(100.0 * ratio, 0), Report::tr("% of limit"), {}};
}

QString helpWords(const std::string& percent) {
  return Report::tr("Help fixed at %1 %").arg(QString::fromStdString(percent));
}

KeyFigure forceFigure(const std::optional<double>& share) {
  const QString label = Report::tr("Largest force");
  if (!share) return {label, dash(), {}, Report::tr("not measured")};
  return {label, number(100.0 * *share, 0), Report::tr("% of limit"), Report::tr("at the sling")};
}

KeyFigure helpFigure(const therapy::SessionMeasures& measures) {
  const QString label = Report::tr("Mean help");
  if (!measures.help_level) return {label, dash(), {}, Report::tr("robot held its position")};
  const double adapting = 100.0 * measures.help_adapting_share.value_or(0.0);
  return {label, number(100.0 * *measures.help_level, 0), Report::tr("%"),
          Report::tr("adapting %1 % of the time").arg(number(adapting, 0))};
}

}  // namespace

QString exerciseWords(const std::string& id) {
  return lookedUp({{"reach", Report::tr("Reach forward")},
                   {"lift", Report::tr("Lift the arm")},
                   {"side", Report::tr("Move to the side")},
                   {"circle", Report::tr("Draw a circle")},
                   {"turn", Report::tr("Turn the forearm")},
                   {"free", Report::tr("Free movement")}},
                  id);
}

QString mappingWords(const std::string& id) {
  return lookedUp({{"follow", Report::tr("Same movement in space")}, {"mirror", Report::tr("Mirrored")}}, id);
}

QString sideWords(const std::string& id) {
  return lookedUp(
      {{"left", Report::tr("Left")}, {"right", Report::tr("Right")}, {"", Report::tr("Not recorded")}}, id);
}

QString eventWords(const std::string& id) {
  constexpr std::string_view kHelpFixed = "help.fixed.";
  if (id.starts_with(kHelpFixed)) return helpWords(id.substr(kHelpFixed.size()));
  return lookedUp(
      {{"aligned", Report::tr("Reference frame set")},
       {"started", Report::tr("Training started")},
       {"paused", Report::tr("Paused")},
       {"finished", Report::tr("Finished")},
       {"stop_reset", Report::tr("Stop reset")},
       {"stop.operator", Report::tr("Stopped: STOP was pressed")},
       {"stop.camera_silent", Report::tr("Stopped: the cameras delivered no images")},
       {"stop.target_lost", Report::tr("Stopped: the arm was out of sight")},
       {"stop.robot_silent", Report::tr("Stopped: the robot did not answer")},
       {"stop.robot_fault", Report::tr("Stopped: the robot reported a fault")},
       {"stop.servo_late", Report::tr("Stopped: the motion loop missed its beat")},
       {"stop.following_error", Report::tr("Stopped: the robot was not where it was told to be")},
       {"stop.internal", Report::tr("Stopped: internal error")},
       {"stop.poor_line", Report::tr("Stopped: the line to the robot was too bad")},
       {"stop.planner_silent", Report::tr("Stopped: the planning of the motion stood still")},
       {"stop.enabling_released", Report::tr("Stopped: the enabling key was let go")},
       {"stop.enabling_pressed_through", Report::tr("Stopped: the enabling key was pressed through")},
       {"stop.force", Report::tr("Stopped: the force at the sling became too large")},
       {"help.adapts", Report::tr("The help adapts to the patient")},
       {"drives_off", Report::tr("The robot gave up its drives")}},
      id);
}

QString clockTime(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

std::vector<Fact> sessionFacts(const ReportContents& contents) {
  const auto& session = contents.session;
  return {{Report::tr("Patient"), QString::fromStdString(contents.patient_code)},
          {Report::tr("Exercise"), exerciseWords(session.exercise)},
          {Report::tr("Impaired side"), sideWords(contents.impaired_side)},
          {Report::tr("Mapping"), mappingWords(session.mapping)},
          {Report::tr("Date"), calendarTime(session.started_at)},
          {Report::tr("Duration"), Report::tr("%1 min").arg(clockTime(contents.duration_s))},
          {Report::tr("End"), endWords(contents)},
          {Report::tr("Software"), QStringLiteral("mirrorarm ") + QString::fromStdString(session.software)}};
}

std::vector<KeyFigure> keyFigures(const ReportContents& contents) {
  const auto& measures = contents.session.measures;
  const QString mm = Report::tr("mm");
  return {
      lagFigure(measures),
      {Report::tr("Error without lag"), number(measures.shape_error_mm, 1), mm,
       Report::tr("rms distance to the goal")},
      {Report::tr("Error as felt"), number(measures.felt_error_mm, 1), mm, Report::tr("rms, lag included")},
      {Report::tr("Gain"), number(measures.gain, 2), {}, Report::tr("1 = same amplitude")},
      {Report::tr("Repetitions"),
       number(measures.repetitions, 0),
       {},
       Report::tr("healthy arm, out and back")},
      {Report::tr("Range of movement"), number(measures.range_mm, 0), mm,
       Report::tr("healthy arm, from the start")},
      {Report::tr("Active time"), clockTime(measures.active_s), Report::tr("min"),
       Report::tr("robot following")},
      {Report::tr("Largest tool speed"), number(measures.tool_speed_m_s, 2), Report::tr("m/s"), {}},
      {Report::tr("Frames tracked"), number(100.0 * measures.tracked_share, 1), Report::tr("%"),
       Report::tr("of %1").arg(QLocale().toString(measures.frames))},
      {Report::tr("Misfit of the target"), number(measures.rms_mm, 2), mm, Report::tr("accepted below 3 mm")},
      ratioFigure(Report::tr("Largest joint speed"), measures.joint_speed_ratio),
      ratioFigure(Report::tr("Largest joint acceleration"), measures.joint_acceleration_ratio),
      forceFigure(measures.force_share),
      helpFigure(measures)};
}

std::vector<QString> explanations() {
  return {
      Report::tr(
          "Lag: the delay of the end effector that fits its path best to the goal's, over all training."),
      Report::tr(
          "Error without lag: rms distance between end effector and goal with that delay taken out; error as "
          "felt: the same with the delay."),
      Report::tr("Gain: slope of the end effector's displacement against the goal's."),
      Report::tr("Largest force: at the sling, of what the plan allows for the region of the body that it "
                 "holds. Mean "
                 "help: over the training; 0 % the softest, 100 % the stiffest springs of the plan."),
      Report::tr("Axes: x from the robot's foot towards the patient, z up."),
      Report::tr(
          "Paper: Busam et al., A Stereo Vision Approach for Cooperative Robotic Movement Therapy, 2015; its "
          "figure is the delay at the start of a movement.")};
}

}  // namespace mirrorarm::ui
