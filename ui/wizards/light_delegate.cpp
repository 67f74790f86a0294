#include "ui/wizards/light_delegate.h"

#include <QPainter>

#include "ui/model/result_list.h"
#include "ui/panels/status_light.h"

namespace mirrorarm::ui {
namespace {

constexpr int kLight_px = 16;
constexpr int kIndent_px = kLight_px + 10;

bool isHeading(const QModelIndex& index) { return !index.data(ResultList::kLightRole).isValid(); }

}  // namespace

void LightDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  QStyleOptionViewItem words = option;
  if (isHeading(index)) {
    words.font.setBold(true);
    return QStyledItemDelegate::paint(painter, words, index);
  }
  words.rect.adjust(kIndent_px, 0, 0, 0);
  QStyledItemDelegate::paint(painter, words, index);
  const auto light = static_cast<Light>(index.data(ResultList::kLightRole).toInt());
  if (light == Light::kOff) return;
  const QRectF place(option.rect.left() + 4, option.rect.center().y() - kLight_px / 2.0 + 0.5, kLight_px,
                     kLight_px);
  drawLight(*painter, place, light, theme_);
}

QSize LightDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return QStyledItemDelegate::sizeHint(option, index) + QSize(isHeading(index) ? 0 : kIndent_px, 0);
}

}  // namespace mirrorarm::ui
