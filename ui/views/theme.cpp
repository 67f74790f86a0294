#include "ui/views/theme.h"

#include <cassert>

#include <QFile>
#include <QRegularExpression>

namespace mirrorarm::ui {
namespace {

FromFile<QString> readText(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text))
    return unexpected(FileError{path, 0, "cannot be read"});
  return QString::fromUtf8(file.readAll());
}

FromFile<QHash<QString, QColor>> readColours(const std::filesystem::path& path) {
  const auto text = readText(path);
  if (!text) return unexpected(text.error());
  static const QRegularExpression entry(QStringLiteral("^(\\w+)\\s+(#[0-9a-fA-F]{6})$"));
  QHash<QString, QColor> colours;
  int number = 0;
  for (const QString& line : text->split(QLatin1Char('\n'))) {
    ++number;
    const QString trimmed = line.trimmed();
    if (trimmed.isEmpty() || trimmed.startsWith(QStringLiteral("# "))) continue;
    const auto match = entry.match(trimmed);
    if (!match.hasMatch()) return unexpected(FileError{path, number, "is not `name #rrggbb`"});
    colours.insert(match.captured(1), QColor(match.captured(2)));
  }
  return colours;
}

/// Puts the colours in place of the @names.
FromFile<QString> fillIn(const std::filesystem::path& path, const QString& sheet,
                         const QHash<QString, QColor>& colours) {
  static const QRegularExpression name(QStringLiteral("@(\\w+)"));
  QString filled;
  int done = 0;
  for (auto matches = name.globalMatch(sheet); matches.hasNext();) {
    const auto match = matches.next();
    filled += sheet.mid(done, match.capturedStart() - done);
    done = match.capturedEnd();
    const auto colour = colours.constFind(match.captured(1));
    if (colour == colours.constEnd())
      return unexpected(FileError{path, 0, "uses the unknown colour " + match.captured(1).toStdString()});
    filled += colour->name();
  }
  return filled + sheet.mid(done);
}

}  // namespace

FromFile<Theme> Theme::read(const std::filesystem::path& folder, const QString& name) {
  auto colours = readColours(folder / (name.toStdString() + ".colours"));
  if (!colours) return unexpected(colours.error());
  const auto path = folder / "workstation.qss";
  const auto sheet = readText(path);
  if (!sheet) return unexpected(sheet.error());
  auto filled = fillIn(path, *sheet, *colours);
  if (!filled) return unexpected(filled.error());
  Theme theme;
  theme.colours_ = std::move(*colours);
  theme.style_sheet_ = std::move(*filled);
  return theme;
}

QColor Theme::colour(const QString& name) const {
  const auto found = colours_.constFind(name);
  assert(found != colours_.constEnd());
  return *found;
}

FromFile<Themes> Themes::read(const std::filesystem::path& folder) {
  auto light = Theme::read(folder, QStringLiteral("light"));
  if (!light) return unexpected(light.error());
  auto dark = Theme::read(folder, QStringLiteral("dark"));
  if (!dark) return unexpected(dark.error());
  return Themes{std::move(*light), std::move(*dark)};
}

}  // namespace mirrorarm::ui
