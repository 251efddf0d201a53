#include "model/perform.hh"

#include <exception>
#include <functional>
#include <map>

#include "model/RecipeEdit.hh"
#include "model/RecipeText.hh"
#include "model/numbers.hh"
#include "render/MeshBuffers.hh"

namespace whittle::viewer {
namespace {

struct Context {
  const Command& command;
  Session& session;
  View& view;
  double aspect;
  const std::string& word(std::size_t i) const { return command.arguments[i]; }
};

using Action = std::function<void(const Context&)>;
using Actions = std::map<std::string, Action>;

void set_target(const Context& c) {
  recipe::Recipe recipe = c.session.recipe();
  recipe.target = {};
  const std::string& kind = c.word(0);
  if (kind != "none" && c.command.arguments.size() != 2) c.command.fail("a target needs a number");
  if (kind == "ratio")
    recipe.target.ratio = c.command.number(1);
  else if (kind == "faces")
    recipe.target.faces = c.command.count(1);
  else if (kind == "vertices")
    recipe.target.vertices = c.command.count(1);
  else if (kind != "none")
    c.command.fail("unknown target '" + kind + "'");
  c.session.change(recipe);
}

void set_bound(const Context& c) {
  auto recipe = c.session.recipe();
  recipe.max_distance.reset();
  if (c.word(0) != "off") recipe.max_distance = recipe::parse_length(c.word(0));
  c.session.change(std::move(recipe));
}

void set_delaunay(const Context& c) {
  recipe::Recipe recipe = c.session.recipe();
  recipe.delaunay.reset();
  if (c.word(0) != "off") recipe.delaunay = c.command.number(0);
  c.session.change(recipe);
}

void set_edges(const Context& c) {
  for (const EdgeSet set : kEdgeSets) {
    if (c.word(0) != name(set)) continue;
    c.view.shows(set) = c.command.on(1);
    return;
  }
  c.command.fail("unknown edges '" + c.word(0) + "'");
}

Actions recipe_actions() {
  return {
      {"recipe", [](const Context& c) { c.session.change(load_recipe(c.word(0))); }},
      {"save-recipe", [](const Context& c) { save_recipe(c.word(0), c.session.recipe()); }},
      {"module",
       [](const Context& c) {
         recipe::Recipe recipe = c.session.recipe();
         recipe.modules = {recipe::parse_spec(c.word(0))};
         c.session.change(recipe);
       }},
      {"add", [](const Context& c) { c.session.change(with_added(c.session.recipe(), c.word(0))); }},
      {"remove",
       [](const Context& c) { c.session.change(without(c.session.recipe(), c.command.count(0) - 1)); }},
      {"move",
       [](const Context& c) {
         c.session.change(with_moved(c.session.recipe(), c.command.count(0) - 1, c.command.count(1) - 1));
       }},
      {"set",
       [](const Context& c) {
         c.session.change(with_value(c.session.recipe(), c.command.count(0) - 1, c.word(1), c.word(2)));
       }},
      {"target", set_target},
      {"driver",
       [](const Context& c) {
         recipe::Recipe recipe = c.session.recipe();
         recipe.driver = recipe::parse_driver(c.word(0));
         c.session.change(recipe);
       }},
      {"levels", [](const Context& c) { c.session.set_levels(c.command.on(0)); }},
      {"bound", set_bound},
      {"delaunay", set_delaunay},
      {"undo", [](const Context& c) { c.session.undo(); }},
      {"redo", [](const Context& c) { c.session.redo(); }},
      {"live", [](const Context& c) { c.session.set_live(c.command.on(0)); }},
      {"run", [](const Context& c) { c.session.run(); }},
  };
}

Actions view_actions() {
  return {
      {"layout",
       [](const Context& c) {
         const auto layout = layout_named(c.word(0));
         if (!layout) c.command.fail("unknown layout '" + c.word(0) + "'");
         c.view.layout = *layout;
       }},
      {"shading",
       [](const Context& c) {
         const auto shading = shading_named(c.word(0));
         if (!shading) c.command.fail("unknown shading '" + c.word(0) + "'");
         c.view.shading = *shading;
       }},
      {"heat", [](const Context& c) { c.view.heat = c.command.on(0); }},
      {"heat-top",
       [](const Context& c) {
         c.view.heat_top.reset();
         if (c.word(0) != "auto") c.view.heat_top = c.command.number(0);
       }},
      {"edges", set_edges},
      {"feature-angle", [](const Context& c) { c.view.feature_angle = c.command.number(0); }},
      {"plan",
       [](const Context& c) {
         c.view.plan = c.command.on(0);
         c.session.set_plan_wanted(c.view.plan);
       }},
      {"split", [](const Context& c) { c.view.split = c.command.number(0); }},
      {"frame",
       [](const Context& c) {
         if (c.session.model()) c.view.orbit.frame(c.session.model()->box(), c.aspect);
       }},
      {"turn", [](const Context& c) { c.view.orbit.turn(c.command.number(0), c.command.number(1)); }},
      {"pan", [](const Context& c) { c.view.orbit.pan(c.command.number(0), c.command.number(1), c.aspect); }},
      {"zoom",
       [](const Context& c) {
         c.view.orbit.zoom(c.command.number(0), c.command.number(1), c.command.number(2), c.aspect);
       }},
      {"up", [](const Context& c) { c.view.orbit.set_up(c.word(0) == "z" ? Orbit::Up::z : Orbit::Up::y); }},
  };
}

Actions file_actions() {
  return {
      {"open", [](const Context& c) { c.session.open(c.word(0)); }},
      {"numbers", [](const Context& c) { files::write_file(c.word(0), numbers(c.session).dump(2) + "\n"); }},
      {"export", [](const Context& c) { c.session.export_result(c.word(0), false); }},
      {"copy-command",
       [](const Context& c) { files::write_file(c.word(0), c.session.command("out.ply") + "\n"); }},
  };
}

}  // namespace

bool perform(const Command& command, Session& session, View& view, double aspect) {
  static const Actions actions = [] {
    Actions all = recipe_actions();
    all.merge(view_actions());
    all.merge(file_actions());
    return all;
  }();
  const auto action = actions.find(command.name);
  if (action == actions.end()) return false;
  try {
    action->second({command, session, view, aspect});
  } catch (const ScriptError&) {
    throw;
  } catch (const std::exception& error) {
    command.fail(error.what());
  }
  return true;
}

}  // namespace whittle::viewer
