#include "ui/model/report_job.h"

#include <QMetaObject>

namespace mirrorarm::ui {

ReportJob::ReportJob(Read read, QObject* parent) : QObject(parent), read_(std::move(read)) {}

ReportJob::~ReportJob() {
  if (worker_.joinable()) worker_.join();
}

void ReportJob::start(std::int64_t session) {
  if (busy_) return;
  busy_ = true;
  if (worker_.joinable()) worker_.join();
  emit started();
  worker_ = std::thread([this, session] {
    auto draw = read_(session);
    QMetaObject::invokeMethod(
        this, [this, draw = std::move(draw)] { finish(draw); }, Qt::QueuedConnection);
  });
}

void ReportJob::finish(const Expected<Draw, QString>& draw) {
  const Expected<QString, QString> made = draw ? (*draw)() : unexpected(draw.error());
  busy_ = false;
  emit finished(made ? ReportResult{*made, {}} : ReportResult{{}, made.error()});
}

}  // namespace mirrorarm::ui
