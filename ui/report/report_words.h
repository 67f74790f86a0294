#pragma once

#include <string>

#include <QString>

#include "ui/report/report_contents.h"

namespace mirrorarm::ui {

// The words of the report for what the records hold as ids. Translated; an id that is not known is shown as
// it is.

[[nodiscard]] QString exerciseWords(const std::string& id);
[[nodiscard]] QString mappingWords(const std::string& id);
[[nodiscard]] QString sideWords(const std::string& id);
/// Of an event's or a session's end: "started", "stop.operator", "finished".
[[nodiscard]] QString eventWords(const std::string& id);

/// One line of the title block.
struct Fact {
  QString label;
  QString value;
};
[[nodiscard]] std::vector<Fact> sessionFacts(const ReportContents& contents);

/// One of the large figures, with its unit and a remark that may be empty.
struct KeyFigure {
  QString label;
  QString value;
  QString unit;
  QString remark;
};
[[nodiscard]] std::vector<KeyFigure> keyFigures(const ReportContents& contents);

/// How the figures are made, a sentence each.
[[nodiscard]] std::vector<QString> explanations();

/// "4:07", minutes and seconds.
[[nodiscard]] QString clockTime(double seconds);

}  // namespace mirrorarm::ui
