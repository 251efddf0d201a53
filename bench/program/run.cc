#include <iostream>

#include "experiment/Environment.hh"
#include "experiment/Experiment.hh"
#include "experiment/GeneratedMesh.hh"
#include "experiment/Inspector.hh"
#include "experiment/Model.hh"
#include "experiment/Peers.hh"
#include "experiment/Sets.hh"
#include "experiment/Store.hh"
#include "files/MeshFile.hh"
#include "program/Interrupt.hh"
#include "program/commands.hh"
#include "report/Report.hh"
#include "results/json.hh"

namespace whittle::bench {
namespace {

/// A tenth of the mean edge is painted in the heat maps' last colour.
constexpr double kHeatScaleEdges = 0.1;

bool is_software(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
    if (renderer.find(name) != std::string::npos) return true;
  return false;
}

void stop_if_interrupted() {
  if (interrupt_signal() != 0) throw Stopped();
}

std::vector<SetDefinition> definitions(const std::string& experiment, const CommandLine& line) {
  if (experiment == "paper1") return line.sets;
  if (experiment == "paper2") return paper2_sets();
  std::vector<PeerName> names;
  for (const Peer& peer : peers()) names.push_back({peer.name, peer.label});
  return beyond_sets(names);
}

/// One run of the program.
class Run {
 public:
  explicit Run(const CommandLine& line)
      : line_(line), progress_(std::cerr, terminal::style_on_stderr(line.quiet)), context_(line.device) {
    model_ = load_model(line.model, WHITTLE_ASSET_CACHE, line.label);
    monkey_ = load_monkey(line.monkey, WHITTLE_ASSET_CACHE);
    plan();
  }

  int time_everything() {
    const Store store(line_.out);
    try {
      return time_everything(store);
    } catch (const files::FileError& error) {
      throw SaveError(std::string(error.what()) +
                      "; what was saved before is whole, and --resume goes on from there");
    }
  }

  int time_everything(const Store& store) {
    begin(store);
    tell_notes();
    for (auto& experiment : results_.experiments) run_experiment(experiment, store);
    results_.complete = true;
    store.save(results_);
    progress_.say("writing the report");
    write_report(results_, line_.out);
    progress_.clear();
    if (!line_.quiet) std::cout << "the report is in " << (line_.out / "report.html").string() << "\n";
    return tell_what_failed();
  }

  int take_pictures() {
    tell_notes();
    for (auto& experiment : results_.experiments) {
      const Model& model = model_of(experiment);
      const Inspector inspector(model.mesh, results_.settings, experiment, line_.out);
      SetMaker maker(model.mesh);
      const auto all = definitions(experiment.name, line_);
      for (auto& set : experiment.sets) {
        stop_if_interrupted();
        progress_.say("taking pictures: " + experiment.name + ", " + set.definition.name);
        const auto& made = maker.make(set.definition, all);
        if (!made.mesh.triangles.empty() && set.definition.role != Role::cache)
          inspector.take_pictures(set, made.mesh);
      }
    }
    progress_.clear();
    if (!line_.quiet) std::cout << "pictures are in " << (line_.out / "pictures").string() << "\n";
    return 0;
  }

 private:
  const Model& model_of(const ExperimentResult& experiment) const {
    return experiment.name == "paper2" ? *monkey_ : model_;
  }

  /// What is to be done, before any of it is.
  void plan() {
    Protocol protocol = line_.protocol(is_software(context_.facts().renderer));
    results_.protocol = protocol.name;
    results_.settings = protocol.settings;
    results_.environment = environment(context_.facts());
    for (const auto& name : line_.experiments) {
      if (name == "paper2" && !monkey_) {
        results_.notes.push_back(
            "Suzanne is not there (assets/fetch.sh suzanne gets it), so Paper 2's experiment was left out");
        continue;
      }
      ExperimentResult experiment;
      experiment.name = name;
      experiment.model = facts(name == "paper2" ? *monkey_ : model_);
      experiment.timing = protocol.timing(name);
      experiment.heat_scale = kHeatScaleEdges * experiment.model.mean_edge;
      for (const auto& definition : definitions(name, line_))
        experiment.sets.emplace_back().definition = definition;
      results_.experiments.push_back(std::move(experiment));
    }
  }

  /// Once nothing stands in the way of the run: a run that cannot be ends with its one line alone.
  void tell_notes() const {
    for (const auto& note : results_.notes) std::cerr << "whittle-bench: " << note << "\n";
    for (const auto& note : model_.notes) std::cerr << "whittle-bench: " << note << "\n";
  }

  void begin(const Store& store) {
    auto earlier = line_.resume ? store.load() : std::nullopt;
    if (line_.resume && !earlier)
      std::cerr << "whittle-bench: there are no results to go on with; this is a first start\n";
    if (earlier) {
      const std::string why = difference(*earlier, results_);
      if (!why.empty()) throw std::invalid_argument("--resume: cannot go on with these results: " + why);
      results_ = std::move(*earlier);
      ++results_.starts;
      results_.complete = false;
    } else if (const auto aside = store.set_aside()) {
      std::cerr << "whittle-bench: older results are now " << aside->string() << "\n";
    }
    store.save(results_);
  }

  /// Errors measured on the same mesh in an experiment before need not be measured again.
  void borrow_fidelity(const ExperimentResult& experiment, SetResult& set) const {
    if (set.definition.role == Role::peer || set.definition.role == Role::cache) return;
    for (const auto& other : results_.experiments) {
      if (other.name == experiment.name || other.name == "paper2" || experiment.name == "paper2") continue;
      for (const auto& known : other.sets)
        if (known.definition.recipe == set.definition.recipe && known.fidelity) set.fidelity = known.fidelity;
    }
  }

  bool has_pictures(const SetResult& set) const {
    for (const auto& name : {set.pictures.whole, set.pictures.detail, set.pictures.heat})
      if (!name.empty() && !std::filesystem::exists(line_.out / name)) return false;
    return true;
  }

  void run_experiment(ExperimentResult& experiment, const Store& store) {
    const Model& model = model_of(experiment);
    SetMaker maker(model.mesh);
    const Inspector inspector(model.mesh, results_.settings, experiment, line_.out);
    std::vector<SetDefinition> all;
    for (const auto& set : experiment.sets) all.push_back(set.definition);
    std::vector<const IndexedMesh*> meshes;
    progress_.expect(experiment.sets.size());
    for (auto& set : experiment.sets) {
      stop_if_interrupted();
      progress_.step("decimating and measuring: " + experiment.name + ", " + set.definition.name);
      const MadeSet& made = maker.make(set.definition, all);
      meshes.push_back(&made.mesh);
      if (set.made && set.triangles != made.mesh.triangles.size())
        throw std::invalid_argument("--resume: set " + set.definition.name + " had " +
                                    std::to_string(set.triangles) + " triangles and now has " +
                                    std::to_string(made.mesh.triangles.size()));
      if (set.made && has_pictures(set)) continue;
      borrow_fidelity(experiment, set);
      inspector.inspect(set, made);
      store.save(results_);
    }
    const render::Renderer renderer;
    const auto& settings = results_.settings;
    const auto camera = views(model.mesh, static_cast<double>(settings.width) / settings.height).whole;
    time_sets(renderer, camera, settings, meshes, results_.starts, experiment,
              {progress_, [&] { store.save(results_); }, [] { return interrupt_signal() != 0; }});
  }

  int tell_what_failed() const {
    int code = 0;
    for (const auto& experiment : results_.experiments)
      for (const auto& set : experiment.sets)
        if (set.triangles == 0) {
          std::cerr << "whittle-bench: " << experiment.name << ", " << set.definition.name << ": " << set.note
                    << "\n";
          code = 1;
        }
    return code;
  }

  const CommandLine& line_;
  terminal::Progress progress_;
  egl::EglContext context_;
  Model model_;
  std::optional<Model> monkey_;
  Results results_;
};

}  // namespace

int run(const CommandLine& line) {
  Run run(line);
  return line.pictures_only ? run.take_pictures() : run.time_everything();
}

int remake_report(const CommandLine& line) {
  const auto results = [&] {
    try {
      return parse_results(read_text(*line.report));
    } catch (const ResultsError& error) {
      throw ResultsError(line.report->string() + ": " + error.what());
    }
  }();
  std::filesystem::create_directories(line.out);
  files::check_creatable(line.out / "report.html");
  try {
    write_report(results, line.out, line.report->parent_path());
  } catch (const files::FileError& error) {
    throw SaveError(error.what());
  }
  std::cout << "the report is in " << (line.out / "report.html").string() << "\n";
  return 0;
}

}  // namespace whittle::bench
