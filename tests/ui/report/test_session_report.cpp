#include <fstream>
#include <iterator>

#include <QApplication>
#include <QProcess>
#include <QStandardPaths>
#include <gtest/gtest.h>

#include "tests/ui/report/synthetic_record.h"
#include "ui/language/language.h"
#include "ui/report/session_report.h"

namespace mirrorarm::ui {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What a poppler tool prints about the file.
QString told(const QString& tool, const std::filesystem::path& pdf) {
  QProcess process;
  process.start(tool, {QString::fromStdString(pdf.string()), QStringLiteral("-")});
  process.waitForFinished();
  return QString::fromUtf8(process.readAllStandardOutput());
}

bool isMissing(const QString& tool) { return QStandardPaths::findExecutable(tool).isEmpty(); }

TEST(SessionReport, IsAPdfOfVectorsAndWhole) {
  const SyntheticRecord record;
  const auto pdf = record.folder / "reports" / "session.pdf";
  const auto written = writeSessionReport(*record.store, record.session, pdf);
  ASSERT_TRUE(written) << written.error();
  const auto bytes = bytesOf(pdf);
  EXPECT_EQ(bytes.rfind("%PDF-", 0), 0u);
  EXPECT_NE(bytes.find("%%EOF"), std::string::npos);
  EXPECT_EQ(bytes.find("/Subtype /Image"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(pdf.parent_path()), {}), 1);
}

TEST(SessionReport, SaysWhatItShould) {
  if (isMissing("pdftotext")) GTEST_SKIP() << "pdftotext is not installed";
  const SyntheticRecord record;
  const auto pdf = record.folder / "session.pdf";
  ASSERT_TRUE(writeSessionReport(*record.store, record.session, pdf));
  const auto text = told("pdftotext", pdf);
  for (const char* words :
       {"Session report", "P-0042", "SIMULATION", "Reach forward", "Mirrored", "140", "paper: 318.7 ms",
        "Tracking quality", "Stopped: the arm was out of sight", "Page 1 of"})
    EXPECT_TRUE(text.contains(words)) << words;
  EXPECT_FALSE(text.contains("Secret"));
}

TEST(SessionReport, OnlyASimulationIsMarkedAsOne) {
  if (isMissing("pdftotext")) GTEST_SKIP() << "pdftotext is not installed";
  const SyntheticRecord record;
  const auto pdf = record.folder / "session.pdf";
  auto contents = *reportContents(*record.store, record.session);
  contents.session.simulated = false;
  ASSERT_TRUE(writeReport(contents, pdf));
  EXPECT_FALSE(told("pdftotext", pdf).contains("simul", Qt::CaseInsensitive));
}

TEST(SessionReport, SpeaksGerman) {
  if (isMissing("pdftotext")) GTEST_SKIP() << "pdftotext is not installed";
  ASSERT_TRUE(useLanguage("de"));
  const SyntheticRecord record;
  const auto pdf = record.folder / "session.pdf";
  ASSERT_TRUE(writeSessionReport(*record.store, record.session, pdf));
  ASSERT_TRUE(useLanguage("en"));
  const auto text = told("pdftotext", pdf);
  for (const char* words :
       {"Sitzungsbericht", "Nach vorn greifen", "318,7 ms", "Halt: der Arm war außer Sicht", "Seite 1"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words;
  EXPECT_FALSE(useLanguage("xx"));
}

TEST(SessionReport, AnEmptyAndACutOffSessionHaveOneToo) {
  for (const int frames : {0, 1, 48}) {
    const SyntheticRecord record(false, frames);
    EXPECT_TRUE(writeSessionReport(*record.store, record.session, record.folder / "session.pdf")) << frames;
  }
}

TEST(SessionReport, AnUnwritablePlaceLeavesNothing) {
  const SyntheticRecord record;
  std::ofstream(record.folder / "file") << "x";
  const auto written =
      writeSessionReport(*record.store, record.session, record.folder / "file" / "session.pdf");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().find('\n'), std::string::npos);
}

}  // namespace
}  // namespace mirrorarm::ui

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
