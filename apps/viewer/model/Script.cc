#include "model/Script.hh"

#include <sstream>

#include "model/number.hh"
#include "model/words.hh"

namespace whittle::viewer {
namespace {

struct Form {
  const char *name, *arguments;
  std::size_t least, most;
  const char* meaning;
};

constexpr std::size_t kAny = 1000;
constexpr Form kForms[] = {
    {"open", "FILE", 1, 1, "open a mesh"},
    {"drop", "FILE …", 1, kAny, "as if the files were dropped on the window"},
    {"wait", "", 0, 0, "until nothing is loading, decimating, measuring or being drawn"},
    {"await", "FILE", 1, 1, "until there is such a file: another program may act in between"},
    {"recipe", "FILE", 1, 1, "load a recipe"},
    {"save-recipe", "FILE", 1, 1, "save it"},
    {"module", "SPEC", 1, 1, "make this module the whole chain"},
    {"add", "SPEC", 1, 1, "append a module to the chain"},
    {"remove", "N", 1, 1, "take the N-th module out, from 1"},
    {"move", "N M", 2, 2, "put the N-th module into the M-th place"},
    {"set", "N KEY VALUE", 3, 3, "set a parameter of the N-th module"},
    {"slide", "N KEY FROM TO STEPS", 5, 5, "move a slider: one value a frame, without waiting"},
    {"target", "none | ratio R | faces N | vertices N", 1, 2, "set the target"},
    {"driver", "NAME", 1, 1, "choose the executor"},
    {"levels", "on | off", 1, 1, "whether mq makes one plan for all levels"},
    {"bound", "LENGTH | off", 1, 1, "how far the result may lie from the original"},
    {"delaunay", "DEGREES | off", 1, 1, "retriangulate at the end"},
    {"undo", "", 0, 0, "undo a recipe change"},
    {"redo", "", 0, 0, "do it again"},
    {"live", "on | off", 1, 1, "whether a change runs at once"},
    {"run", "", 0, 0, "run the recipe"},
    {"layout", "side-by-side | split | original | result", 1, 1, "what is seen"},
    {"shading", "smooth | flat | wires | wires-over", 1, 1, "how"},
    {"heat", "on | off", 1, 1, "colours by distance"},
    {"heat-top", "UNITS | auto", 1, 1, "the distance at the upper end of the colours"},
    {"edges", "boundary | non-manifold | feature | locked  on | off", 2, 2, "draw edges"},
    {"feature-angle", "DEGREES", 1, 1, "from where on an edge is a feature"},
    {"plan", "on | off", 1, 1, "draw what the first module would merge"},
    {"split", "X", 1, 1, "put the split line there, 0 to 1"},
    {"frame", "", 0, 0, "see all of the model"},
    {"turn", "YAW PITCH", 2, 2, "turn the camera, degrees"},
    {"pan", "DX DY", 2, 2, "move the model, in half pictures"},
    {"zoom", "FACTOR X Y", 3, 3, "zoom towards a place, from -1 to 1"},
    {"up", "y | z", 1, 1, "which axis points upward"},
    {"drag", "BUTTON X0 Y0 X1 Y1", 5, 5, "drag the mouse (left, middle, right) over the view, 0 to 1"},
    {"scroll", "X Y CLICKS", 3, 3, "turn the wheel over a place of the view"},
    {"pull", "NAME X0 X1", 3, 3, "drag the mouse over a slider or histogram, 0 to 1; 'places' names them"},
    {"places", "FILE", 1, 1, "where the window's sliders and histograms are, as JSON"},
    {"key", "NAME", 1, 1, "press a key: F, ?, Escape, Ctrl+Z, …"},
    {"resize", "WIDTH HEIGHT", 2, 2, "resize the window"},
    {"screenshot", "FILE [WIDTHxHEIGHT]", 1, 2, "the whole window as PNG"},
    {"picture", "FILE [WIDTHxHEIGHT]", 1, 2, "the views alone as PNG"},
    {"ask-picture", "FILE WIDTHxHEIGHT", 2, 2,
     "the same as by the Picture button: goes on while it is drawn"},
    {"grab", "FILE", 1, 1, "the window's next frame as PNG, just as it is shown"},
    {"frame-times", "FILE", 1, 1, "how long the window was busy at a time since the last of these, as JSON"},
    {"numbers", "FILE", 1, 1, "the figures as JSON"},
    {"export", "FILE", 1, 1, "write the result; the extension says the format"},
    {"copy-command", "FILE", 1, 1, "write the command line that does the same"},
    {"expect-error", "TEXT", 1, 1, "a message with this text must be on the screen; it is closed"},
    {"close", "", 0, 0, "close the window"}};

const Form* find_form(const std::string& name) {
  for (const Form& form : kForms)
    if (name == form.name) return &form;
  return nullptr;
}

}  // namespace

void Command::fail(const std::string& message) const {
  throw ScriptError(place + ": " + message);
}

double Command::number(std::size_t argument) const {
  const auto value = to_number(arguments[argument]);
  if (!value) fail("'" + arguments[argument] + "' is not a number");
  return *value;
}

std::size_t Command::count(std::size_t argument) const {
  const double value = number(argument);
  if (value < 1 || value > 1e9 || value != static_cast<double>(static_cast<std::size_t>(value)))
    fail("'" + arguments[argument] + "' is not a whole number of at least 1");
  return static_cast<std::size_t>(value);
}

bool Command::on(std::size_t argument) const {
  if (arguments[argument] != "on" && arguments[argument] != "off")
    fail("'" + arguments[argument] + "' is neither on nor off");
  return arguments[argument] == "on";
}

std::vector<Command> parse_script(const std::string& text, const std::string& name) {
  std::vector<Command> commands;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    Command command;
    command.place = name + ":" + std::to_string(++number);
    try {
      command.arguments = split_words(line);
    } catch (const WordsError& error) {
      command.fail(error.what());
    }
    if (command.arguments.empty()) continue;
    command.name = command.arguments.front();
    command.arguments.erase(command.arguments.begin());
    const Form* form = find_form(command.name);
    if (!form) command.fail("unknown command '" + command.name + "'");
    if (command.arguments.size() < form->least || command.arguments.size() > form->most)
      command.fail("usage: " + std::string(form->name) + " " + form->arguments);
    commands.push_back(std::move(command));
  }
  return commands;
}

std::string script_help() {
  std::string text;
  for (const Form& form : kForms) {
    text += "  " + std::string(form.name) + (*form.arguments ? " " : "") + form.arguments + "\n      " +
            form.meaning + "\n";
  }
  return text;
}

}  // namespace whittle::viewer
