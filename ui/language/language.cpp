#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

// Outside every namespace: the macro declares a function of the resource compiler.
static void loadTranslations() { Q_INIT_RESOURCE(translations); }

namespace mirrorarm::ui {

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

bool useLanguage(const QString& code) {
  const QString name = QStringLiteral("translator in use");
  if (!languages().contains(code)) return false;
  delete QCoreApplication::instance()->findChild<QTranslator*>(name);
  QLocale::setDefault(QLocale(code));
  if (code == QLatin1String("en")) return true;
  loadTranslations();
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName(name);
  return translator->load(QStringLiteral(":/translations/mirrorarm_%1.qm").arg(code)) &&
         QCoreApplication::installTranslator(translator);
}

}  // namespace mirrorarm::ui
