#include "core/records/session_rows.h"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <soci/soci.h>

namespace mirrorarm::records {
namespace {

using therapy::SessionMeasures;

struct CountColumn {
  const char* name;
  int SessionMeasures::*member;
};
struct FigureColumn {
  const char* name;
  double SessionMeasures::*member;
};
struct KnownColumn {
  const char* name;
  std::optional<double> SessionMeasures::*member;
};
constexpr std::array kCounts{CountColumn{"frames", &SessionMeasures::frames},
                             CountColumn{"repetitions", &SessionMeasures::repetitions}};
constexpr std::array kFigures{
    FigureColumn{"tracked_share", &SessionMeasures::tracked_share},
    FigureColumn{"rms_mm", &SessionMeasures::rms_mm},
    FigureColumn{"lag_ms", &SessionMeasures::lag_ms},
    FigureColumn{"gain", &SessionMeasures::gain},
    FigureColumn{"felt_error_mm", &SessionMeasures::felt_error_mm},
    FigureColumn{"shape_error_mm", &SessionMeasures::shape_error_mm},
    FigureColumn{"tool_speed_m_s", &SessionMeasures::tool_speed_m_s},
    FigureColumn{"range_mm", &SessionMeasures::range_mm},
    FigureColumn{"path_mm", &SessionMeasures::path_mm},
    FigureColumn{"active_s", &SessionMeasures::active_s},
    FigureColumn{"joint_speed_ratio", &SessionMeasures::joint_speed_ratio},
    FigureColumn{"joint_acceleration_ratio", &SessionMeasures::joint_acceleration_ratio}};
/// Empty where they are not known.
constexpr std::array kKnowns{KnownColumn{"force_share", &SessionMeasures::force_share},
                             KnownColumn{"help_level", &SessionMeasures::help_level},
                             KnownColumn{"help_adapting_share", &SessionMeasures::help_adapting_share}};

/// ", PREFIXname SUFFIX" for every column of the measures.
std::string measureList(const std::string& prefix, const std::string& suffix = "",
                        const std::string& suffix_of_known = "") {
  std::string list;
  for (const auto& column : kCounts) list += ", " + prefix + column.name + suffix;
  for (const auto& column : kFigures) list += ", " + prefix + column.name + suffix;
  for (const auto& column : kKnowns) list += ", " + prefix + column.name + suffix_of_known;
  return list;
}

/// A number that may be missing, as it lies in its column.
struct KnownCell {
  double value = 0.0;
  soci::indicator there = soci::i_null;

  void set(const std::optional<double>& known) {
    if (known && !std::isfinite(*known)) throw std::runtime_error("a number is not finite");
    value = known.value_or(0.0);
    there = known ? soci::i_ok : soci::i_null;
  }
  [[nodiscard]] std::optional<double> known() const {
    return there == soci::i_ok ? std::optional(value) : std::nullopt;
  }
};

/// Where a row of a select is put: session and measures, which are missing until the session is finished.
class SessionRow {
 public:
  SessionRow(soci::session& sql, const std::string& condition) : statement_(sql) {
    for (long long* number : {&id_, &patient_id_}) statement_.exchange(soci::into(*number));
    for (std::string* text :
         {&row_.started_at, &row_.ended_at, &row_.exercise, &row_.mapping, &row_.end_reason, &row_.software})
      statement_.exchange(soci::into(*text));
    statement_.exchange(soci::into(simulated_));
    for (std::size_t i = 0; i < kCounts.size(); ++i)
      statement_.exchange(soci::into(row_.measures.*kCounts[i].member, count_there_[i]));
    for (std::size_t i = 0; i < kFigures.size(); ++i)
      statement_.exchange(soci::into(row_.measures.*kFigures[i].member, figure_there_[i]));
    for (auto& known : knowns_) statement_.exchange(soci::into(known.value, known.there));
    statement_.alloc();
    statement_.prepare(
        "select session.id, patient_id, started_at, ended_at, exercise, mapping, end_reason, software, "
        "simulated" +
        measureList("session_measures.") +
        " from session left join session_measures on session_measures.session_id = session.id where " +
        condition + " order by session.id");
    statement_.define_and_bind();
    statement_.execute();
  }

  bool next() { return statement_.fetch(); }

  [[nodiscard]] Session value() const {
    Session session = row_;
    session.id = id_;
    session.patient_id = patient_id_;
    session.simulated = simulated_ != 0;
    if (count_there_.front() == soci::i_null) session.measures = {};
    for (std::size_t i = 0; i < kKnowns.size(); ++i) session.measures.*kKnowns[i].member = knowns_[i].known();
    return session;
  }

 private:
  soci::statement statement_;
  Session row_;
  long long id_ = 0, patient_id_ = 0;
  int simulated_ = 0;
  std::array<soci::indicator, kCounts.size()> count_there_{};
  std::array<soci::indicator, kFigures.size()> figure_there_{};
  std::array<KnownCell, kKnowns.size()> knowns_{};
};

}  // namespace

std::string measuresTable() {
  return "create table session_measures (session_id integer primary key references session (id)" +
         measureList("", " real not null", " real") + ")";
}

void insertMeasures(soci::session& sql, std::int64_t session, const SessionMeasures& measures) {
  const long long id = session;
  soci::statement insert(sql);
  insert.exchange(soci::use(id));
  for (const auto& column : kCounts) insert.exchange(soci::use(measures.*column.member));
  for (const auto& column : kFigures) insert.exchange(soci::use(measures.*column.member));
  std::array<KnownCell, kKnowns.size()> knowns;
  for (std::size_t i = 0; i < kKnowns.size(); ++i) {
    knowns[i].set(measures.*kKnowns[i].member);
    insert.exchange(soci::use(knowns[i].value, knowns[i].there));
  }
  insert.alloc();
  insert.prepare("insert into session_measures (session_id" + measureList("") + ") values (:id" +
                 measureList(":") + ")");
  insert.define_and_bind();
  insert.execute(true);
}

std::vector<Session> selectSessions(soci::session& sql, const std::string& condition) {
  SessionRow row(sql, condition);
  std::vector<Session> sessions;
  while (row.next()) sessions.push_back(row.value());
  return sessions;
}

}  // namespace mirrorarm::records
