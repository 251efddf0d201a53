#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "files/MeshFile.hh"
#include "model/RecipeEdit.hh"
#include "model/number.hh"
#include "model/perform.hh"
#include "window/App.hh"

namespace whittle::viewer {
namespace {

int mouse_button(const Command& command) {
  const std::string& name = command.arguments[0];
  if (name == "left") return 0;
  if (name == "right") return 1;
  if (name == "middle") return 2;
  command.fail("unknown button '" + name + "'");
}

/// Commands that may be given while a message is on the screen.
bool minds_no_message(const Command& command) {
  for (const char* name : {"expect-error", "wait", "await", "screenshot", "grab", "resize", "key"})
    if (command.name == name) return true;
  return false;
}

}  // namespace

void App::follow_script() {
  while (!script_.empty() && !pointer_.moving() && frames_due_ == 0) {
    const Command command = script_.front();
    if (!session_.errors.empty() && !minds_no_message(command))
      command.fail("unexpected message: " + session_.errors.front());
    if (!do_command(command)) return;
    script_.pop_front();
    frames_due_ = 2;
  }
}

bool App::do_command(const Command& command) {
  if (perform(command, session_, view_, panes(view_, ui_.area, session_.outcome()).front().picture.aspect()))
    return true;
  if (command.name == "wait") return at_rest();
  if (command.name == "await") return std::filesystem::exists(command.arguments[0]);
  if (command.name == "slide") return slide(command);
  return do_window_command(command);
}

bool App::slide(const Command& command) {
  const double from = command.number(2), to = command.number(3);
  const int steps = static_cast<int>(command.count(4));
  const std::size_t place = command.count(0) - 1;
  // Values with the unit that the parameter has now.
  const auto& modules = session_.recipe().modules;
  if (place >= modules.size()) command.fail("there is no such module");
  const auto now = modules[place].word(command.arguments[1]);
  const std::string unit = now ? recipe::suffix(recipe::parse_length(*now).unit) : "";
  const double value = rounded(from + (to - from) * slide_step_ / std::max(steps - 1, 1), 4);
  session_.change(with_value(session_.recipe(), place, command.arguments[1], text::shortest(value) + unit),
                  "slide." + command.arguments[1]);
  if (++slide_step_ < steps) {
    frames_due_ = 1;
    return false;
  }
  slide_step_ = 0;
  session_.end_of_drag();
  return true;
}

void App::write_places(const std::string& path) const {
  nlohmann::ordered_json json;
  for (const auto& [name, place] : ui_.places)
    json[name] = {{"x", place.x}, {"y", place.y}, {"width", place.width}, {"height", place.height}};
  files::write_file(path, json.dump(2) + "\n");
}

void App::write_frame_times(const std::string& path) {
  const std::size_t sketches = views_ ? views_->sketches() : 0, pictures = views_ ? views_->pictures() : 0;
  std::sort(busy_.begin(), busy_.end());
  const auto at = [&](double part) {
    return busy_.empty() ? 0 : busy_[static_cast<std::size_t>(part * static_cast<double>(busy_.size() - 1))];
  };
  const nlohmann::ordered_json json{{"times", busy_.size()},
                                    {"median_ms", at(0.5)},
                                    {"p95_ms", at(0.95)},
                                    {"max_ms", at(1)},
                                    {"sketches", sketches - std::min(sketches_, sketches)},
                                    {"pictures", pictures - std::min(pictures_, pictures)}};
  files::write_file(path, json.dump(2) + "\n");
  busy_.clear();
  sketches_ = sketches;
  pictures_ = pictures;
}

bool App::do_window_command(const Command& command) {
  const auto& words = command.arguments;
  try {
    if (command.name == "drop") {
      for (const std::string& path : words) session_.open(path);
    } else if (command.name == "drag") {
      pointer_.drag(mouse_button(command), ui_.area, command.number(1), command.number(2), command.number(3),
                    command.number(4));
    } else if (command.name == "scroll") {
      pointer_.scroll(ui_.area, command.number(0), command.number(1), command.number(2));
    } else if (command.name == "pull") {
      const auto place = ui_.places.find(words[0]);
      if (place == ui_.places.end()) command.fail("there is no '" + words[0] + "' on the screen");
      pointer_.drag(0, place->second, command.number(1), 0.5, command.number(2), 0.5);
    } else if (command.name == "places") {
      write_places(words[0]);
    } else if (command.name == "grab") {
      grab_ = words[0];
    } else if (command.name == "frame-times") {
      write_frame_times(words[0]);
    } else if (command.name == "key") {
      if (!press_key(ui_, words[0])) command.fail("no such key");
    } else if (command.name == "resize") {
      window_.resize(static_cast<int>(command.count(0)), static_cast<int>(command.count(1)));
    } else if (command.name == "screenshot" || command.name == "picture") {
      int width = window_.width(), height = window_.height();
      if (words.size() > 1 && std::sscanf(words[1].c_str(), "%dx%d", &width, &height) != 2)
        command.fail("'" + words[1] + "' is not WIDTHxHEIGHT");
      write_picture(words[0], width, height, command.name == "screenshot");
    } else if (command.name == "ask-picture") {
      PictureRequest request{words[0]};
      if (std::sscanf(words[1].c_str(), "%dx%d", &request.width, &request.height) != 2)
        command.fail("'" + words[1] + "' is not WIDTHxHEIGHT");
      ui_.picture = request;
    } else if (command.name == "expect-error") {
      if (session_.errors.empty()) command.fail("there is no message");
      if (session_.errors.front().find(words[0]) == std::string::npos)
        command.fail("the message is: " + session_.errors.front());
      session_.errors.pop_front();
    } else if (command.name == "close") {
      window_.close();
    }
  } catch (const ScriptError&) {
    throw;
  } catch (const std::exception& error) {
    command.fail(error.what());
  }
  return true;
}

}  // namespace whittle::viewer
