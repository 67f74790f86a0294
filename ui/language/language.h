#pragma once

#include <QString>
#include <QStringList>

namespace mirrorarm::ui {

/// Languages that the program speaks, as ISO 639-1 codes: "en", which the texts are written in, and the
/// translated.
[[nodiscard]] QStringList languages();

/// Words and numbers in `code` from now on, for what is shown or drawn afterwards. False for a language that
/// the program does not speak. GUI thread, with an application.
[[nodiscard]] bool useLanguage(const QString& code);

}  // namespace mirrorarm::ui
