#pragma once

#include <QColor>
#include <QFont>

namespace mirrorarm::ui::report {

// Lengths on the page are in units of 1/96 inch (A4: 794 x 1123), so that fonts and plots share one measure.

inline constexpr double kPageWidth = 794.0, kPageHeight = 1123.0;
inline constexpr double kMargin = 57.0;  ///< 15 mm
inline constexpr double kContentWidth = kPageWidth - 2.0 * kMargin;

inline const QColor kInk(0x1B, 0x27, 0x33);
inline const QColor kQuietInk(0x5A, 0x66, 0x72);
inline const QColor kLine(0xD5, 0xDB, 0xE1);
inline const QColor kCard(0xF5, 0xF7, 0xF9);
inline const QColor kRest(0xEC, 0xEF, 0xF2);
// Okabe and Ito's colours: told apart by every kind of colour vision, and dark against light in print.
inline const QColor kHealthy(0x00, 0x72, 0xB2);
inline const QColor kImpaired(0xE6, 0x9F, 0x00);
inline const QColor kStop(0xD5, 0x5E, 0x00);

/// The report's typeface, `size` units high.
[[nodiscard]] inline QFont font(int size, QFont::Weight weight = QFont::Normal) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(size);
  font.setWeight(weight);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

}  // namespace mirrorarm::ui::report
