#include <QApplication>
#include <QStyleFactory>
#include <gtest/gtest.h>

#include "ui/views/scene_view.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  mirrorarm::ui::SceneView::prepareSurface();
  const QApplication application(argc, argv);
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  return RUN_ALL_TESTS();
}
