#include "ui/language/language.h"

#include <string>
#include <string_view>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

// Outside every namespace: the macro declares a function of the resource compiler.
static void loadTranslations() { Q_INIT_RESOURCE(translations); }

namespace mirrorarm::ui {
namespace {

/// A class says its words under its full name; Qt 5.15's lupdate does not read namespaces like ours and files
/// them under the bare one.
class Translator : public QTranslator {
 public:
  using QTranslator::QTranslator;
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int count) const override {
    const std::string_view full(context);
    const auto bare = full.substr(full.rfind(':') + 1);  // all of it where there is no colon
    return QTranslator::translate(std::string(bare).c_str(), source, disambiguation, count);
  }
};

}  // namespace

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

bool useLanguage(const QString& code) {
  const QString name = QStringLiteral("translator in use");
  if (!languages().contains(code)) return false;
  delete QCoreApplication::instance()->findChild<QTranslator*>(name);
  QLocale::setDefault(QLocale(code));
  if (code == QLatin1String("en")) return true;
  loadTranslations();
  auto* translator = new Translator(QCoreApplication::instance());
  translator->setObjectName(name);
  return translator->load(QStringLiteral(":/translations/mirrorarm_%1.qm").arg(code)) &&
         QCoreApplication::installTranslator(translator);
}

}  // namespace mirrorarm::ui
