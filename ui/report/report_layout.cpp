#include "ui/report/report_layout.h"

namespace mirrorarm::ui::report {

std::vector<Page> paginate(const std::vector<Block>& blocks, double height) {
  std::vector<Page> pages(1);
  double top = 0.0;
  for (const auto& block : blocks) {
    if (top + block.height > height && !pages.back().empty()) {
      pages.emplace_back();
      top = 0.0;
    }
    pages.back().push_back({&block, top});
    top += block.height + block.space_after;
  }
  return pages;
}

}  // namespace mirrorarm::ui::report
