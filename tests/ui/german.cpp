#include "tests/ui/german.h"

#include <stdexcept>

#include <QAbstractButton>
#include <QFile>
#include <QLabel>
#include <QSet>
#include <QXmlStreamReader>

#include "ui/language/language.h"

namespace mirrorarm::ui::test {
namespace {

QSet<QString> englishTexts() {
  QFile file(QStringLiteral(RESOURCES "/../translations/mirrorarm_de.ts"));
  if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error("the translation cannot be read");
  QXmlStreamReader xml(&file);
  QSet<QString> texts;
  QString source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() == QLatin1String("translation") && xml.readElementText() != source) texts.insert(source);
  }
  return texts;
}

QStringList wordsOf(const QWidget& widget) {
  QStringList words{widget.accessibleName(), widget.accessibleDescription(), widget.toolTip(),
                    widget.windowTitle()};
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) words << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    words << button->text().remove(QStringLiteral("☐ ")).remove(QStringLiteral("☑ "));
  return words;
}

}  // namespace

InGerman::InGerman() {
  if (!useLanguage(QStringLiteral("de"))) throw std::runtime_error("the program speaks no German");
}

InGerman::~InGerman() { static_cast<void>(useLanguage(QStringLiteral("en"))); }

QStringList englishIn(const QWidget& window) {
  static const QSet<QString> english = englishTexts();
  QStringList found;
  for (const auto* widget : window.findChildren<QWidget*>())
    for (const auto& words : wordsOf(*widget))
      if (english.contains(words)) found << words;
  return found;
}

}  // namespace mirrorarm::ui::test
