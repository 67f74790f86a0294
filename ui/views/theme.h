#pragma once

#include <filesystem>

#include <QColor>
#include <QHash>
#include <QString>

#include "core/common/file_error.h"

namespace mirrorarm::ui {

/// The colours of the whole screen and the style sheet made of them. A value.
class Theme {
 public:
  /// Reads `folder`/`name`.colours and `folder`/workstation.qss. Refused: a missing file, a line that is no
  /// "name #rrggbb", a style sheet that uses an unknown colour.
  [[nodiscard]] static FromFile<Theme> read(const std::filesystem::path& folder, const QString& name);

  /// A colour that the theme has; to ask for another is a bug.
  [[nodiscard]] QColor colour(const QString& name) const;
  [[nodiscard]] const QString& styleSheet() const { return style_sheet_; }

 private:
  QHash<QString, QColor> colours_;
  QString style_sheet_;
};

/// The two looks of the screen.
struct Themes {
  Theme light;
  Theme dark;
  [[nodiscard]] static FromFile<Themes> read(const std::filesystem::path& folder);
};

}  // namespace mirrorarm::ui
