#include <cmath>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

const std::filesystem::path kStyle = std::filesystem::path(RESOURCES) / "style";

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// WCAG 2.2.
double contrast(const QColor& one, const QColor& other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

class ThemeOf : public ::testing::TestWithParam<const char*> {
 protected:
  Theme theme_ = Theme::read(kStyle, QLatin1String(GetParam())).value();
  double between(const char* one, const char* other) {
    return contrast(theme_.colour(QLatin1String(one)), theme_.colour(QLatin1String(other)));
  }
};

TEST_P(ThemeOf, TextCanBeRead) {
  const std::vector<std::pair<const char*, const char*>> pairs{{"text", "surface"},
                                                               {"text", "window"},
                                                               {"text", "surface_sunken"},
                                                               {"text", "accent_soft"},
                                                               {"text_muted", "surface"},
                                                               {"text_muted", "window"},
                                                               {"text_muted", "surface_sunken"},
                                                               {"on_accent", "accent"},
                                                               {"on_accent", "accent_hover"},
                                                               {"on_accent", "accent_pressed"},
                                                               {"on_stop", "stop"},
                                                               {"on_stop", "stop_hover"},
                                                               {"on_stop", "stop_pressed"},
                                                               {"on_simulation", "simulation"},
                                                               {"on_alarm_high", "alarm_high"},
                                                               {"on_alarm_medium", "alarm_medium"},
                                                               {"on_alarm_low", "alarm_low"},
                                                               {"image_text", "image_ground"},
                                                               {"image_refused", "image_ground"}};
  for (const auto& [text, ground] : pairs) EXPECT_GE(between(text, ground), 4.5) << text << " on " << ground;
}

TEST_P(ThemeOf, ShapesCanBeSeen) {
  for (const char* shape : {"border_strong", "accent", "outline", "healthy", "impaired", "goal"})
    EXPECT_GE(between(shape, "surface"), 3.0) << shape;
  EXPECT_GE(between("stop", "window"), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Both, ThemeOf, ::testing::Values("light", "dark"));

void write(const QDir& folder, const char* name, const QByteArray& text) {
  QFile file(folder.filePath(QLatin1String(name)));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

TEST(Theme, RefusesWhatIsWrongWithItsPlace) {
  const QTemporaryDir temporary;
  const QDir folder(temporary.path());
  const std::filesystem::path path = temporary.path().toStdString();
  EXPECT_FALSE(Theme::read(path, QStringLiteral("light")));
  write(folder, "workstation.qss", "QLabel { color: @ink; }");
  write(folder, "light.colours", "ink #000000\npaper white\n");
  const auto wrong = Theme::read(path, QStringLiteral("light"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().line, 2);
  write(folder, "light.colours", "paper #ffffff\n");
  const auto unknown = Theme::read(path, QStringLiteral("light"));
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().reason.find("ink"), std::string::npos);
  write(folder, "light.colours", "ink #000000\n");
  EXPECT_EQ(Theme::read(path, QStringLiteral("light")).value().styleSheet(),
            QStringLiteral("QLabel { color: #000000; }"));
}

}  // namespace
}  // namespace mirrorarm::ui
