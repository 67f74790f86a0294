#pragma once

#include <QString>

#include "ui/model/board_overlay.h"

class QPainter;

namespace mirrorarm::ui {

class ImageCell;
class Theme;

/// Over the image of `cell`: where points have been so far, the board that is seen, and where it is wanted.
void drawBoard(QPainter& painter, ImageCell& cell, const QSizeF& image_px, const BoardOverlay& overlay,
               const Theme& theme, const QString& caption);

}  // namespace mirrorarm::ui
