#pragma once

#include <cstdint>
#include <functional>
#include <thread>

#include <QObject>
#include <QString>

#include "core/common/expected.h"

namespace mirrorarm::ui {

/// What came of making a report.
struct ReportResult {
  QString file;    ///< the PDF, empty when it failed
  QString reason;  ///< why it failed, for an engineer
};

/// Makes one session's report: reads the record on a thread of its own, then draws it on the screen's thread,
/// where the plots must be drawn.
class ReportJob : public QObject {
  Q_OBJECT
 public:
  /// Draws what was read and gives the PDF's path, or the reason. Called on the screen's thread.
  using Draw = std::function<Expected<QString, QString>()>;
  /// Reads the record of `session`. Called on the worker.
  using Read = std::function<Expected<Draw, QString>(std::int64_t session)>;

  explicit ReportJob(Read read, QObject* parent = nullptr);
  ~ReportJob() override;

  /// Does nothing while one is being made.
  void start(std::int64_t session);
  [[nodiscard]] bool isBusy() const { return busy_; }

 signals:
  void started();
  void finished(const mirrorarm::ui::ReportResult& result);

 private:
  void finish(const Expected<Draw, QString>& draw);

  Read read_;
  bool busy_ = false;
  std::thread worker_;  // joined before it is used again and at the end
};

}  // namespace mirrorarm::ui
