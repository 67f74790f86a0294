#pragma once

#include <vector>

#include "ui/report/report_contents.h"
#include "ui/report/report_layout.h"

namespace mirrorarm::ui::report {

/// The whole report from its title to the explanations, in reading order. `contents` outlives the blocks.
[[nodiscard]] std::vector<Block> blocksOf(const ReportContents& contents);

}  // namespace mirrorarm::ui::report
