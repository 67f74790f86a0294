#include "benchmarks/report.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "core/common/atomic_file.h"

namespace mirrorarm::benchmarks {
namespace {

std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string cellOf(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& figure : figures) {
    if (!text.empty()) text += "; ";
    text += figure.name + " " + shortNumber(figure.value);
    if (!figure.unit.empty()) text += " " + figure.unit;
  }
  return cell(text);
}

std::string_view verdict(const Row& row) {
  if (!row.pass) return "";
  return *row.pass ? "pass" : "short";
}

nlohmann::json toJson(const std::vector<Figure>& figures) {
  auto list = nlohmann::json::array();
  for (const Figure& figure : figures) {
    nlohmann::json value;  // null
    if (std::isfinite(figure.value)) value = figure.value;
    list.push_back({{"name", figure.name}, {"value", value}, {"unit", figure.unit}});
  }
  return list;
}

nlohmann::json toJson(const Row& row) {
  nlohmann::json pass;
  if (row.pass) pass = *row.pass;
  return {{"section", row.section},
          {"name", row.name},
          {"goal", row.goal},
          {"measured", toJson(row.measured)},
          {"references", toJson(row.references)},
          {"pass", pass}};
}

}  // namespace

Machine thisMachine() {
  Machine machine{"unknown", std::thread::hardware_concurrency()};
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      machine.processor = line.substr(std::min(line.find(':') + 2, line.size()));
      break;
    }
  return machine;
}

std::string shortNumber(double value) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  if (value == std::round(value) && std::abs(value) < 1e7)
    std::snprintf(text, sizeof text, "%.0f", value);
  else
    std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string toMarkdown(const Report& report) {
  std::string text = "# Benchmark " + report.suite + "\n\nmirrorarm " MIRRORARM_VERSION ", " +
                     report.machine.processor + ", " + std::to_string(report.machine.cores) +
                     " cores, seed " + std::to_string(report.seed) +
                     (report.quick ? ", quick: few trials" : "") + "\n";
  std::string_view section;
  for (const Row& row : report.rows) {
    if (row.section != section)
      text += "\n## " + row.section + "\n\n| | goal | measured | reference | |\n|---|---|---|---|---|\n";
    section = row.section;
    text += "| " + cell(row.name) + " | " + cell(row.goal) + " | " + cellOf(row.measured) + " | " +
            cellOf(row.references) + " | " + std::string(verdict(row)) + " |\n";
  }
  return text;
}

std::string toJson(const Report& report) {
  nlohmann::json json{{"suite", report.suite},
                      {"version", MIRRORARM_VERSION},
                      {"quick", report.quick},
                      {"seed", report.seed},
                      {"machine", {{"processor", report.machine.processor}, {"cores", report.machine.cores}}},
                      {"rows", nlohmann::json::array()}};
  for (const Row& row : report.rows) json["rows"].push_back(toJson(row));
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Expected<void, std::string> writeReport(const std::filesystem::path& folder, const Report& report) {
  const auto write = [&](std::string_view ending, const std::string& text) {
    return writeWhole(folder / (report.suite + std::string(ending)), [&](std::ostream& out) { out << text; });
  };
  if (auto written = write(".md", toMarkdown(report)); !written) return written;
  return write(".json", toJson(report));
}

}  // namespace mirrorarm::benchmarks
