#include "batch/Memory.hh"

#include <ctime>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "batch/Claim.hh"
#include "files/MeshFile.hh"
#include "text/utc.hh"
#include "version/Version.hh"

namespace whittle::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Null where there is none, or it is damaged.
Json read(const fs::path& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return file ? Json::parse(text, nullptr, false) : Json();
}

/// A file name need not be UTF-8; a replacement character is better than no log.
std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void fill_counts(const Json& report, Outcome& outcome) {
  if (!report.is_object()) return;
  outcome.faces_before = report.value(Json::json_pointer("/input/faces"), std::size_t{0});
  outcome.faces_after = report.value(Json::json_pointer("/output/faces"), std::size_t{0});
}

}  // namespace

Memory::Memory(const Order& order) : order_(order), folder_(order.out / ".whittle") {
  for (const char* name : {"claims", "work", "done", "log"}) fs::create_directories(folder_ / name);
  log_ = folder_ / "log" / (process_name() + "-" + std::to_string(std::time(nullptr)) + ".jsonl");
}

fs::path Memory::work(const Item& item) const {
  return folder_ / "work" / (item.name + "." + process_name() + ".json");
}

void Memory::forget_work(const Item& item) const {
  std::error_code ignored;
  fs::remove(work(item), ignored);
}

std::string Memory::key(const Item& item) const {
  std::error_code error;
  std::string key = version::number();
  for (const std::string& argument : order_.arguments) key += "\n" + argument;
  key += "\n" + std::to_string(fs::file_size(item.in, error));
  key += "\n" + std::to_string(fs::last_write_time(item.in, error).time_since_epoch().count());
  return key;
}

bool Memory::knows(const Item& item, Outcome& outcome) const {
  std::error_code error;
  if (!fs::exists(item.out, error)) return false;
  const Json kept = read(done(item));
  if (!kept.is_object() || kept.value("key", "") != key(item)) return false;
  fill_counts(kept.value("report", Json()), outcome);
  return true;
}

void Memory::keep(const Item& item, Outcome& outcome) const {
  const Json report = read(work(item));
  fill_counts(report, outcome);
  files::write_file(done(item), line({{"key", key(item)}, {"report", report}}));
  forget_work(item);
}

void Memory::log(const Item& item, const Outcome& outcome) const {
  std::ofstream file(log_, std::ios::app);
  file << line({{"file", item.in.string()},
                {"out", item.out.string()},
                {"status", to_string(outcome.status)},
                {"faces_before", outcome.faces_before},
                {"faces_after", outcome.faces_after},
                {"seconds", outcome.seconds},
                {"message", outcome.message},
                {"process", process_name()},
                {"time_utc", text::now_utc()}})
       << std::flush;
}

}  // namespace whittle::batch
