#include "core/common/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace mirrorarm {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

template <class Number>
bool parseWhole(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::vector<std::string> splitCells(std::string_view text, char separator) {
  std::vector<std::string> cells;
  for (;;) {
    const auto end = text.find(separator);
    cells.emplace_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    text.remove_prefix(end + 1);
  }
}

bool parseNumber(std::string_view text, double& number) {
  return parseWhole(text, number) && std::isfinite(number);
}

FromFile<CsvTable> CsvTable::read(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) return unexpected(FileError{file, 0, "cannot be read"});
  CsvTable table;
  table.file_ = file;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (trimmed(text).empty()) continue;
    auto cells = splitCells(text, ',');
    if (table.header_.empty()) {
      table.header_ = std::move(cells);
    } else if (cells.size() == table.header_.size()) {
      table.rows_.push_back({line, std::move(cells)});
    } else {
      return unexpected(FileError{file, line,
                                  "has " + std::to_string(cells.size()) + " cells where the header has " +
                                      std::to_string(table.header_.size())});
    }
  }
  if (in.bad()) return unexpected(FileError{file, 0, "reading stopped before the end"});
  if (table.header_.empty()) return unexpected(FileError{file, 1, "has no header line"});
  return table;
}

int CsvTable::column(std::string_view name) const {
  const auto at = std::find(header_.begin(), header_.end(), name);
  return at == header_.end() ? -1 : static_cast<int>(at - header_.begin());
}

FromFile<std::vector<int>> CsvTable::columns(std::span<const std::string_view> names) const {
  std::vector<int> found;
  for (const auto name : names) {
    const int at = column(name);
    if (at < 0) return unexpected(FileError{file_, 1, "has no column " + std::string(name)});
    found.push_back(at);
  }
  return found;
}

FromFile<double> CsvTable::number(const CsvRow& row, int column) const {
  double value = 0.0;
  const auto& cell = row.cells[static_cast<std::size_t>(column)];
  if (parseNumber(cell, value)) return value;
  return unexpected(
      FileError{file_, row.line,
                header_[static_cast<std::size_t>(column)] + " is not a finite number: '" + cell + "'"});
}

FromFile<long long> CsvTable::integer(const CsvRow& row, int column) const {
  long long value = 0;
  const auto& cell = row.cells[static_cast<std::size_t>(column)];
  if (parseWhole(std::string_view(cell), value)) return value;
  return unexpected(FileError{
      file_, row.line, header_[static_cast<std::size_t>(column)] + " is not a whole number: '" + cell + "'"});
}

}  // namespace mirrorarm
