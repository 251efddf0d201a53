#include "report/sections.hh"
#include "results/text.hh"

namespace whittle::bench {
namespace {

std::vector<std::string> row(const std::string& label, const SetResult& set, const ExperimentResult& e) {
  const double edge = e.model.mean_edge;
  std::vector<std::string> cells = {label, thousands(double(set.triangles))};
  if (!set.fidelity) {
    cells.resize(12, kNone);
    return cells;
  }
  const Fidelity& f = *set.fidelity;
  for (const double length : {f.rms, f.mean, f.max}) cells.push_back(fixed(100 * length / edge, 2));
  for (const double angle : {f.normal_mean_degrees, f.normal_max_degrees}) cells.push_back(fixed(angle, 1));
  for (const double quality : {f.quality_mean, f.quality_p05}) cells.push_back(fixed(quality, 3));
  cells.push_back(fixed(f.psnr_db, 1) + " (" + fixed(f.psnr_worst_db, 1) + ")");
  cells.push_back(fixed(f.ssim, 4) + " (" + fixed(f.ssim_worst, 4) + ")");
  cells.push_back(std::to_string(set.flipped_faces));
  return cells;
}

Table fidelity_table(const ExperimentResult& e, const std::string& caption, std::initializer_list<Role> roles,
                     bool with_base) {
  Table table{caption,
              {"Set", "Triangles", "RMS", "Mean", "Max", "Normals mean, °", "max, °", "Quality mean", "5 %",
               "PSNR (worst view), dB", "SSIM (worst view)", "Flipped"},
              {},
              1};
  for (const SetResult& set : e.sets) {
    bool wanted = false;
    for (const Role role : roles) wanted |= set.definition.role == role;
    if (!wanted || set.definition.original()) continue;
    const SetResult* const base = with_base ? find(e, set.definition.compared_with) : nullptr;
    if (base != nullptr) table.rows.push_back(row(base->definition.label + ", defaults", *base, e));
    table.rows.push_back(row(set.definition.label, set, e));
  }
  return table;
}

void add_heat(Section& section, const ExperimentResult& e, std::initializer_list<Role> roles,
              const std::string& caption) {
  Gallery gallery{caption + " Violet is no error, yellow is " + short_number(e.heat_scale) +
                      " model units (a tenth of the mean edge) or more, painted on the original.",
                  {},
                  false};
  for (const SetResult& set : e.sets)
    for (const Role role : roles)
      if (set.definition.role == role && !set.pictures.heat.empty()) {
        const bool peer = role == Role::peer;
        gallery.pictures.push_back(
            {set.pictures.heat,
             set.definition.label + (peer ? ", as many triangles as " + set.definition.compared_with : "")});
      }
  if (!gallery.pictures.empty()) section.blocks.push_back(gallery);
}

}  // namespace

Section fidelity_section(const Results& results) {
  Section section{"fidelity", "How faithful the sets are", {}};
  section.blocks.push_back(
      Paragraph{"RMS, mean and max are two-sided distances in percent of the original's mean edge, from "
                "samples spread evenly by "
                "area on both surfaces, and all vertices. Normals: the angle between each simplified face "
                "and the nearest "
                "original face, weighted by area. Quality: 4√3·area / (a²+b²+c²), 1 is equilateral; 5 %: one "
                "triangle in "
                "twenty is worse. PSNR and SSIM compare the luma of " +
                std::to_string(results.settings.views) +
                " views with the original's, over the pixels where either shows the model; formulas in "
                "docs/benchmark.md."});
  if (const ExperimentResult* const e = find(results, "paper1")) {
    section.blocks.push_back(
        fidelity_table(*e, "Paper 1's sets, lengths in % of the mean edge", {Role::paper}, false));
    add_heat(section, *e, {Role::paper}, "Where the error is: Paper 1's sets.");
  }
  if (const ExperimentResult* const e = find(results, "beyond")) {
    Table table =
        fidelity_table(*e, "The papers' literal words beside Whittle's defaults, without a flip guard",
                       {Role::literal}, true);
    if (!table.rows.empty()) section.blocks.push_back(table);
    add_heat(section, *e, {Role::literal}, "Where the error is: literal words.");
    Gallery ears{"The ears by the papers' literal words. Red is the inner side of the surface.", {}, false};
    for (const SetResult& set : e->sets)
      if (set.definition.role == Role::literal && !set.pictures.detail.empty())
        ears.pictures.push_back({set.pictures.detail, set.definition.label});
    if (!ears.pictures.empty()) section.blocks.push_back(ears);
  }
  if (const ExperimentResult* const e = find(results, "paper2")) {
    section.blocks.push_back(fidelity_table(*e, "Paper 2's sets, lengths in % of Suzanne's mean edge",
                                            {Role::paper, Role::literal}, false));
    add_heat(section, *e, {Role::paper, Role::literal}, "Where the error is: Paper 2's sets.");
  }
  return section;
}

}  // namespace whittle::bench
