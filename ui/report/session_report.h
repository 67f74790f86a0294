#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/common/expected.h"
#include "core/records/store.h"
#include "ui/report/report_contents.h"

namespace mirrorarm::ui {

/// Draws `contents` as an A4 PDF in the application's language: title, key figures, courses, events; vectors
/// and text throughout. Whole or nothing. GUI thread, with a QApplication (its offscreen platform will do):
/// the plots are widgets that are never shown. The error is one line.
[[nodiscard]] Expected<void, std::string> writeReport(const ReportContents& contents,
                                                      const std::filesystem::path& pdf);

/// Reads `session` from the store and draws its report. GUI thread; long sessions are better read with
/// reportContents() on another one.
[[nodiscard]] Expected<void, std::string> writeSessionReport(records::Store& store, std::int64_t session,
                                                             const std::filesystem::path& pdf);

}  // namespace mirrorarm::ui
