#include <QCoreApplication>
#include <QEventLoop>
#include <QThread>
#include <gtest/gtest.h>

#include "ui/model/report_job.h"

namespace mirrorarm::ui {
namespace {

ReportResult run(ReportJob& job) {
  int argc = 0;
  const QCoreApplication app(argc, nullptr);
  QEventLoop loop;
  ReportResult result;
  QObject::connect(&job, &ReportJob::finished, &loop, [&](const ReportResult& made) {
    result = made;
    loop.quit();
  });
  job.start(7);
  EXPECT_TRUE(job.isBusy());
  loop.exec();
  EXPECT_FALSE(job.isBusy());
  return result;
}

TEST(ReportJob, ReadsOnAWorkerAndDrawsOnTheScreensThread) {
  QThread* read_on = nullptr;
  QThread* drawn_on = nullptr;
  ReportJob job([&](std::int64_t session) -> Expected<ReportJob::Draw, QString> {
    read_on = QThread::currentThread();
    return ReportJob::Draw([&, session]() -> Expected<QString, QString> {
      drawn_on = QThread::currentThread();
      return QStringLiteral("session-%1.pdf").arg(session);
    });
  });
  EXPECT_EQ(run(job).file, QStringLiteral("session-7.pdf"));
  EXPECT_EQ(drawn_on, QThread::currentThread());
  EXPECT_NE(read_on, drawn_on);
}

TEST(ReportJob, TellsWhyItFailed) {
  ReportJob job([](std::int64_t) -> Expected<ReportJob::Draw, QString> {
    return unexpected(QStringLiteral("no such session"));
  });
  const auto result = run(job);
  EXPECT_TRUE(result.file.isEmpty());
  EXPECT_EQ(result.reason, QStringLiteral("no such session"));
}

}  // namespace
}  // namespace mirrorarm::ui
