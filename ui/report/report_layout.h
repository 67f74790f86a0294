#pragma once

#include <functional>
#include <vector>

#include <QRectF>

class QCPPainter;

namespace mirrorarm::ui::report {

/// A piece of the report that is not torn apart: it gets the full width of the text and its own height.
struct Block {
  double height = 0.0;
  double space_after = 0.0;  ///< dropped at the end of a page
  std::function<void(QCPPainter& painter, const QRectF& place)> draw;
};

/// A block and where it begins on its page.
struct PlacedBlock {
  const Block* block = nullptr;
  double top = 0.0;
};
using Page = std::vector<PlacedBlock>;

/// The blocks in their order on pages of `height`; at least one page. A block that is higher than a page gets
/// one of its own. The blocks outlive the pages.
[[nodiscard]] std::vector<Page> paginate(const std::vector<Block>& blocks, double height);

}  // namespace mirrorarm::ui::report
