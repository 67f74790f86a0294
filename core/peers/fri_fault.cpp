#include "core/peers/fri_fault.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "core/common/csv.h"

namespace mirrorarm::peers {
namespace {

constexpr std::array<std::string_view, 13> kKinds{
    "lost",     "late", "duplicated", "reordered",   "short",        "long",      "garbled",
    "wrong_id", "nan",  "silence",    "drive_error", "poor_quality", "start_pose"};
constexpr std::string_view kAnswer = "answer-";

/// Cuts what follows `mark` off `text` and reads it as a number of at least 0; false when it is none.
bool takeNumber(std::string_view& text, char mark, double& number) {
  const auto at = text.find(mark);
  if (at == std::string_view::npos) return true;
  const bool read = parseNumber(text.substr(at + 1), number) && number >= 0.0;
  text = text.substr(0, at);
  return read;
}

}  // namespace

Expected<FriFault, std::string> friFaultOf(std::string_view text) {
  const auto refused = [whole = std::string(text)](const std::string& why) {
    return unexpected("'" + whole + "': " + why);
  };
  FriFault fault;
  if (!takeNumber(text, '+', fault.for_s) || !takeNumber(text, '@', fault.from_s) ||
      !takeNumber(text, ':', fault.share) || fault.share > 1.0)
    return refused("is not [answer-]KIND[:SHARE][@FROM_S[+FOR_S]]");
  if (text.starts_with(kAnswer)) {
    fault.to_answers = true;
    text.remove_prefix(kAnswer.size());
  }
  const auto kind = std::find(kKinds.begin(), kKinds.end(), text);
  if (kind == kKinds.end()) return refused("there is no such fault");
  fault.kind = static_cast<FriFaultKind>(kind - kKinds.begin());
  if (fault.to_answers && fault.kind >= FriFaultKind::kSilence) return refused("does not happen to answers");
  return fault;
}

FromFile<std::vector<FriFault>> readFriFaults(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return unexpected(FileError{file, 0, "cannot be read"});
  std::vector<FriFault> faults;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string text = splitCells(line, '#').front();
    if (text.empty()) continue;
    const auto fault = friFaultOf(text);
    if (!fault) return unexpected(FileError{file, number, fault.error()});
    faults.push_back(*fault);
  }
  return faults;
}

}  // namespace mirrorarm::peers
