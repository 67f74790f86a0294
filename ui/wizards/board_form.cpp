#include "ui/wizards/board_form.h"

#include <array>

#include <QGridLayout>
#include <QLabel>

#include "ui/model/calibration_words.h"

namespace mirrorarm::ui {
namespace {

using calibration::BoardKind;

constexpr std::array kKinds{BoardKind::kDotPlate, BoardKind::kChessboard, BoardKind::kCircles,
                            BoardKind::kAsymmetricCircles};
constexpr std::array kModels{camera::LensModel::kBrownConrady, camera::LensModel::kKannalaBrandt};
constexpr int kFewest = 3;  // points in a row: fewer fix no pose
constexpr int kMost = 60;
constexpr int kAutomatic = -1;

template <class Field>
Field* named(const char* name, const QString& accessible) {
  auto* field = new Field;
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(accessible);
  return field;
}

}  // namespace

BoardForm::BoardForm(const calibration::Board& board, QWidget* parent)
    : QWidget(parent),
      kind_(named<QComboBox>("boardKind", tr("Board"))),
      columns_(named<QSpinBox>("boardColumns", tr("Points in a row"))),
      rows_(named<QSpinBox>("boardRows", tr("Rows of points"))),
      step_mm_(named<QDoubleSpinBox>("boardStep", tr("Step from point to point in millimetres"))),
      model_(named<QComboBox>("lensModel", tr("Lens model"))) {
  setObjectName(QStringLiteral("boardForm"));
  for (const auto kind : kKinds) kind_->addItem(words(kind), static_cast<int>(kind));
  model_->addItem(tr("Automatic"), kAutomatic);
  for (const auto model : kModels) model_->addItem(words(model), static_cast<int>(model));
  for (QAbstractSpinBox* field : std::initializer_list<QAbstractSpinBox*>{columns_, rows_, step_mm_})
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  columns_->setRange(kFewest, kMost);
  rows_->setRange(kFewest, kMost);
  step_mm_->setRange(1.0, 500.0);
  step_mm_->setDecimals(3);
  step_mm_->setSuffix(tr(" mm"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(1, 1);
  add(*grid, tr("&Board"), kind_);
  add(*grid, tr("&In a row"), columns_);
  add(*grid, tr("&Rows"), rows_);
  add(*grid, tr("&Step"), step_mm_);
  add(*grid, tr("&Lens"), model_);
  fill(board);
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &BoardForm::changed);
  connect(model_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &BoardForm::changed);
  connect(columns_, QOverload<int>::of(&QSpinBox::valueChanged), this, &BoardForm::changed);
  connect(rows_, QOverload<int>::of(&QSpinBox::valueChanged), this, &BoardForm::changed);
  connect(step_mm_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &BoardForm::changed);
}

void BoardForm::add(QGridLayout& grid, const QString& label, QWidget* field) {
  const int row = grid.rowCount();
  auto* words = new QLabel(label);
  words->setBuddy(field);  // Alt and the underlined letter go there
  grid.addWidget(words, row, 0);
  grid.addWidget(field, row, 1);
}

void BoardForm::fill(const calibration::Board& board) {
  kind_->setCurrentIndex(kind_->findData(static_cast<int>(board.kind)));
  columns_->setValue(board.columns);
  rows_->setValue(board.rows);
  step_mm_->setValue(1e3 * board.spacing_m);
}

calibration::Board BoardForm::board() const {
  return {static_cast<BoardKind>(kind_->currentData().toInt()), columns_->value(), rows_->value(),
          step_mm_->value() / 1e3};
}

std::optional<camera::LensModel> BoardForm::model() const {
  const int chosen = model_->currentData().toInt();
  if (chosen == kAutomatic) return std::nullopt;
  return static_cast<camera::LensModel>(chosen);
}

void BoardForm::setModelAsked(bool asked) { model_->setEnabled(asked); }

}  // namespace mirrorarm::ui
