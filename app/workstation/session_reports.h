#pragma once

#include <filesystem>

#include "ui/model/report_job.h"

namespace mirrorarm::workstation {

/// Reads sessions of `store` and draws their reports beside it, as session-<id>.pdf.
[[nodiscard]] ui::ReportJob::Read sessionReportsOf(const std::filesystem::path& store);

}  // namespace mirrorarm::workstation
