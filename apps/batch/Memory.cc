#include "batch/Memory.hh"

#include <cerrno>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "batch/Claim.hh"
#include "files/MeshFile.hh"
#include "files/own_companions.hh"
#include "text/hash.hh"
#include "text/utc.hh"
#include "version/Version.hh"

namespace whittle::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Null where there is none, or it is damaged.
Json read(const fs::path& path) {
  try {
    return Json::parse(files::read_file(path), nullptr, false);
  } catch (const files::FileError&) {
    return Json();
  }
}

/// A file name need not be UTF-8; a replacement character is better than no log.
std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The text at a place of a record that may hold anything.
std::string text_at(const Json& record, const char* pointer) {
  const Json::json_pointer place(pointer);
  return record.contains(place) && record[place].is_string() ? record[place].get<std::string>() : "";
}

std::size_t count_at(const Json& record, const char* pointer) {
  const Json::json_pointer place(pointer);
  return record.contains(place) && record[place].is_number_unsigned() ? record[place].get<std::size_t>() : 0;
}

void fill_counts(const Json& record, Outcome& outcome) {
  outcome.faces_before = count_at(record, "/report/input/faces");
  outcome.faces_after = count_at(record, "/report/output/faces");
  const auto part = [&](const char* name) {
    const Json::json_pointer place(std::string("/report/") + name);
    return record.contains(place) ? record[place] : Json();
  };
  outcome.attribute_changes = part("attribute_changes");
  outcome.charts = part("charts");
  outcome.pieces = part("pieces");
  outcome.notes = part("notes");
}

/// Size and time of the last change.
std::string stamp(const fs::path& file) {
  std::error_code error;
  return std::to_string(fs::file_size(file, error)) + " " +
         std::to_string(fs::last_write_time(file, error).time_since_epoch().count());
}

/// Whether a file is the result of a record. The time of change spares reading it.
bool is_result(const Json& record, const fs::path& file) {
  if (text_at(record, "/result/stamp") == stamp(file)) return true;
  std::error_code error;
  if (!fs::is_regular_file(file, error) || count_at(record, "/result/bytes") != fs::file_size(file, error))
    return false;
  return text_at(record, "/result/hash") == text::hash(files::read_file(file));
}

/// Where the input is, seen from the results: the same on machines that mount both elsewhere.
std::string place_of(const Item& item, const Order& order) {
  std::error_code error;
  return fs::proximate(item.in, order.out, error).string();
}

/// The stamps of the files that an input names, by their paths from its folder.
Json stamps_of(const Json& names, const fs::path& input) {
  Json stamps = Json::object();
  std::error_code error;
  for (const Json& name : names)
    if (name.is_string())
      stamps[fs::proximate(name.get<std::string>(), input.parent_path(), error).string()] =
          stamp(name.get<std::string>());
  return stamps;
}

/// Whether the files that an input names are those of a record.
bool are_unchanged(const Json& record, const fs::path& input) {
  const Json::json_pointer place("/input/files_beside");
  if (!record.contains(place) || !record[place].is_object()) return false;
  for (const auto& [name, known] : record[place].items())
    if (known != stamp(input.parent_path() / name)) return false;
  return true;
}

}  // namespace

Memory::Memory(const Order& order) : order_(order), folder_(order.out / ".whittle") {
  std::string all = version::number();
  for (const std::string& argument : order.arguments) all += "\n" + argument;
  for (const std::string& file : order.named_files) all += "\n" + text::hash(files::read_file(file));
  arguments_ = text::hash(all);
  for (const char* name : {"claims", "work", "done", "log"}) fs::create_directories(folder_ / name);
  log_ = folder_ / "log" / (process_name() + "-" + std::to_string(std::time(nullptr)) + ".jsonl");
}

fs::path Memory::work(const Item& item, const std::string& process, const char* extension) const {
  return folder_ / "work" / (item.name + "." + process + extension);
}

fs::path Memory::result(const Item& item) const {
  return work(item, process_name(), files::whole_extension(item.out).c_str());
}

fs::path Memory::report(const Item& item) const {
  return work(item, process_name(), ".json");
}

void Memory::forget_work(const Item& item, const std::string& process) const {
  std::error_code ignored;
  fs::remove(work(item, process, files::whole_extension(item.out).c_str()), ignored);
  fs::remove(work(item, process, ".json"), ignored);
}

std::string Memory::input_stamp(const Item& item) const {
  return stamp(item.in);
}

bool Memory::knows(const Item& item, Outcome& outcome) const {
  const Json record = read(done(item));
  std::error_code error;
  if (text_at(record, "/arguments") != arguments_ || !is_result(record, item.out)) return false;
  const bool in_place = fs::equivalent(item.in, item.out, error);
  if (!in_place && (text_at(record, "/input/place") != text::hash(place_of(item, order_)) ||
                    text_at(record, "/input/stamp") != input_stamp(item) || !are_unchanged(record, item.in)))
    return false;
  fill_counts(record, outcome);
  const bool missed = record.value("missed", false);
  outcome.status = missed ? Outcome::Status::missed_before : Outcome::Status::skipped;
  if (missed) outcome.message = text_at(record, "/message");
  return true;
}

void Memory::keep(const Item& item, const std::string& input_stamp, Outcome& outcome) const {
  const std::string bytes = files::read_file(result(item));
  const Json done_report = read(report(item));
  const Json::json_pointer beside("/input/files_beside");
  const Json record = {
      {"arguments", arguments_},
      {"input",
       {{"place", text::hash(place_of(item, order_))},
        {"stamp", input_stamp},
        {"files_beside",
         stamps_of(done_report.contains(beside) ? done_report[beside] : Json::array(), item.in)}}},
      {"result", {{"stamp", stamp(result(item))}, {"bytes", bytes.size()}, {"hash", text::hash(bytes)}}},
      {"missed", outcome.status == Outcome::Status::missed},
      {"message", outcome.message},
      {"report", done_report}};
  files::write_file(done(item), line(record));
  files::OldCompanions old;
  old.look_at(item.out);
  files::move_file(result(item), item.out);
  old.remove_unnamed();
  fill_counts(record, outcome);
}

bool Memory::log(const Item& item, const Outcome& outcome) const {
  std::ofstream file(log_, std::ios::app);
  file << line({{"file", item.in.string()},
                {"out", item.out.string()},
                {"status", to_string(outcome.status)},
                {"faces_before", outcome.faces_before},
                {"faces_after", outcome.faces_after},
                {"seconds", outcome.seconds},
                {"charts", outcome.charts},
                {"pieces", outcome.pieces},
                {"attribute_changes", outcome.attribute_changes},
                {"notes", outcome.notes},
                {"message", outcome.message},
                {"process", process_name()},
                {"time_utc", text::now_utc()}})
       << std::flush;
  return file.good();
}

}  // namespace whittle::batch
