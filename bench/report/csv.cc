#include <cstdio>
#include <sstream>

#include "report/Report.hh"
#include "results/Figures.hh"
#include "results/names.hh"

namespace whittle::bench {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string summary(const Summary& s) {
  return number(s.median) + "," + number(s.min) + "," + number(s.max);
}

}  // namespace

std::string csv_text(const Results& results) {
  std::ostringstream out;
  out << "experiment,set,role,algorithm,recipe,compared_with,vertices,triangles,flipped_faces,nonmanifold_"
         "edges,"
         "decimation_ms,cache_misses_per_triangle,rms_model_units,mean_model_units,max_model_units,"
         "normal_deviation_mean_degrees,normal_deviation_max_degrees,quality_mean,quality_p05,psnr_db,psnr_"
         "worst_db,"
         "ssim,ssim_worst,repetitions,frame_ms_median,frame_ms_min,frame_ms_max,gl_frame_ms_median,"
         "frames_per_second_median,improvement_percent_median,improvement_percent_min,improvement_percent_"
         "max,"
         "certainty\n";
  for (const auto& e : results.experiments)
    for (const SetResult& set : e.sets) {
      const SetDefinition& d = set.definition;
      out << e.name << "," << d.name << "," << to_string(d.role) << "," << quoted(d.algorithm) << ","
          << quoted(d.recipe) << "," << d.compared_with << "," << set.vertices << "," << set.triangles << ","
          << set.flipped_faces << "," << set.nonmanifold_edges << "," << number(set.decimation_ms) << ","
          << number(set.cache_misses_per_triangle) << ",";
      if (const auto& f = set.fidelity) {
        for (const double value : {f->rms, f->mean, f->max, f->normal_mean_degrees, f->normal_max_degrees,
                                   f->quality_mean, f->quality_p05, f->psnr_db, f->psnr_worst_db, f->ssim})
          out << number(value) << ",";
        out << number(f->ssim_worst) << ",";
      } else {
        out << ",,,,,,,,,,,";
      }
      if (const auto f = figures(set, e)) {
        const double timed = double(e.timing.frames_timed());
        out << f->repetitions << "," << summary(f->frame_mean_ms) << ","
            << (f->gl_total_ms ? number(f->gl_total_ms->median / timed) : "") << ","
            << number(f->frames_per_second.median) << "," << summary(f->improvement) << ","
            << to_string(f->certainty);
      } else {
        out << "0,,,,,,,,,";
      }
      out << "\n";
    }
  return out.str();
}

std::string times_csv_text(const Results& results) {
  std::ostringstream out;
  out << "experiment,set,repetition,start,visited_as,frames,wall_total_ms,gl_total_ms\n";
  for (const auto& e : results.experiments)
    for (const SetResult& set : e.sets)
      for (const Visit& v : set.visits)
        out << e.name << "," << set.definition.name << "," << v.repetition << "," << v.start << ","
            << v.visited_as << "," << e.timing.frames_timed() << "," << number(v.wall_ms) << ","
            << (v.gl_ms ? number(*v.gl_ms) : "") << "\n";
  return out.str();
}

}  // namespace whittle::bench
