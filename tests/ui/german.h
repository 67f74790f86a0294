#pragma once

#include <QStringList>
#include <QWidget>

namespace mirrorarm::ui::test {

/// The program speaks German while it lives.
struct InGerman {
  InGerman();
  ~InGerman();
  InGerman(const InGerman&) = delete;
  InGerman& operator=(const InGerman&) = delete;
};

/// What of the words in `window`, shown or hidden, is still English though German has other words for it.
[[nodiscard]] QStringList englishIn(const QWidget& window);

}  // namespace mirrorarm::ui::test
