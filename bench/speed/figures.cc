#include "speed/figures.hh"

#include <algorithm>
#include <cmath>
#include <optional>

namespace whittle::speed {
namespace {

constexpr const char* kPlanned[] = {"vt", "fad", "ivdd", "ss", "vtd", "fass"};
constexpr const char* kShares[] = {"50 %", "25 %", "10 %", "2 %", "1 %"};

/// The results of one model, found by name.
class Results {
 public:
  explicit Results(const Json& model) : model_(model) {}

  const Json* find(const std::string& name) const {
    for (const Json& result : model_.at("results"))
      if (result.at("name") == name && !result.at("seconds").is_null()) return &result;
    return nullptr;
  }
  std::optional<double> seconds(const std::string& name) const {
    const Json* result = find(name);
    if (!result) return std::nullopt;
    return (*result).at("seconds").at("median").get<double>();
  }
  /// How many times longer the first takes than the second.
  std::optional<double> ratio(const std::string& first, const std::string& second) const {
    const auto a = seconds(first), b = seconds(second);
    if (!a || !b || !(*b > 0)) return std::nullopt;
    return *a / *b;
  }
  bool is(const std::string& name) const { return model_.at("name").get<std::string>().rfind(name, 0) == 0; }
  std::string name() const { return model_.at("name"); }
  double faces() const { return model_.at("faces"); }

 private:
  const Json& model_;
};

std::string long_name(const char* method, const char* module) {
  return std::string(method) + " " + module;
}

constexpr const char *kMean = "mean_units", *kRms = "rms_percent_of_diagonal",
                     *kMax = "max_percent_of_diagonal";

std::optional<double> error(const Json* result, const char* which) {
  if (!result || (*result).at("score").is_null() || (*result).at("score").at("distance").is_null())
    return std::nullopt;
  return (*result).at("score").at("distance").at(which).get<double>();
}

/// How many times the error of one contender is another's, at the same share of the faces. None where one of them has two
/// percent more faces left than the other. What is less than a millionth of the diagonal is rounding, and counts as that.
std::optional<double> error_ratio(const Results& results, const char* first, const char* second,
                                  const char* share, const char* which) {
  constexpr double kRounding = 1e-4, kMoreFaces = 1.02;  // percent
  const Json* const a = results.find(long_name(first, share));
  const Json* const b = results.find(long_name(second, share));
  const auto of_a = error(a, which);
  if (!of_a) return std::nullopt;
  const auto of_b = error(b, which);
  if (!of_b) return std::nullopt;
  const double faces_a = (*a).at("score").value("faces", 0.0), faces_b = (*b).at("score").value("faces", 0.0);
  if (std::max(faces_a, faces_b) > kMoreFaces * std::min(faces_a, faces_b)) return std::nullopt;
  return std::max(*of_a, kRounding) / std::max(*of_b, kRounding);
}

/// A ratio for each planned module.
template <typename MakeRatio>
std::vector<Ratio> of_planned(MakeRatio make_ratio) {
  std::vector<Ratio> ratios;
  for (const char* module : kPlanned)
    if (const auto value = make_ratio(module)) ratios.push_back({module, *value, ""});
  return ratios;
}

Figure sweep_against_stock(const Results& results, bool assertions) {
  Figure f{"sweep", "DecimaterT with the same module", "",
           "",      Figure::Bound::at_least,           assertions ? 30.0 : 10.0,
           {}};
  f.ratios = of_planned(
      [&](const char* m) { return results.ratio(long_name("DecimaterT", m), long_name("sweep", m)); });
  return f;
}

Figure sweep_against_meshopt(const Results& results) {
  Figure f{"sweep",
           "meshopt_simplify at the same face count",
           "",
           "",
           Figure::Bound::at_most,
           results.is("dragon") ? 0.35 : 0.6,
           {}};
  f.ratios = of_planned([&](const char* m) {
    return results.ratio(long_name("sweep", m), long_name("meshopt_simplify as", m));
  });
  return f;
}

Figure bulk_against_sloppy(const Results& results) {
  Figure f{"bulk", "meshopt_simplifySloppy at the same face count", "", "", Figure::Bound::at_most, 1.0, {}};
  f.ratios = of_planned([&](const char* m) {
    return results.ratio(long_name("bulk", m), long_name("meshopt_simplifySloppy as", m));
  });
  for (Ratio& ratio : f.ratios) {
    const Json& score = (*results.find("bulk " + ratio.of)).at("score");
    const std::size_t edges = score.is_null() ? 0 : score.at("nonmanifold_edges").get<std::size_t>();
    if (edges > 0) ratio.remark = std::to_string(edges) + " non-manifold edges";
  }
  return f;
}

Figure lazy_against_stock(const Results& results, bool assertions) {
  Figure f{"lazy + ModQuadricT",    "DecimaterT + ModQuadricT", "", "",
           Figure::Bound::at_least, assertions ? 15.0 : 5.0,    {}};
  for (const char* share : kShares) {
    const std::string lazy = long_name("lazy quadric", share), stock = long_name("DecimaterT quadric", share);
    const auto value = results.ratio(stock, lazy);
    if (!value) continue;
    f.ratios.push_back({share, *value, ""});
    const auto lazy_error = error(results.find(lazy), kMean), stock_error = error(results.find(stock), kMean);
    if (lazy_error && stock_error && *lazy_error > 1.01 * *stock_error)
      f.ratios.back().remark = "the mean error is more than 1 % larger";
  }
  return f;
}

Figure lazy_against_meshopt(const Results& results) {
  Figure f{"lazy + ModQuadricT", "meshopt_simplify", "", "", Figure::Bound::at_most, 1.5, {}};
  for (const char* share : kShares)
    if (const auto value =
            results.ratio(long_name("lazy quadric", share), long_name("meshopt_simplify", share)))
      f.ratios.push_back({share, *value, ""});
  return f;
}

Figure mq_against_meshopt(const Results& results, const char* module, double goal) {
  Figure f{long_name("bulk", module), "meshopt_simplify", "", "", Figure::Bound::at_most, goal, {}};
  for (const char* share : kShares)
    if (const auto value =
            results.ratio(long_name("bulk", module) + " " + share, long_name("meshopt_simplify", share)))
      f.ratios.push_back({share, *value, ""});
  return f;
}

/// Not of times but of errors.
Figure mq_error_against(const Results& results, const char* peer) {
  Figure f{"RMS distance of bulk mq", peer, "", "", Figure::Bound::at_most, 1.0, {}};
  for (const char* share : kShares)
    if (const auto value = error_ratio(results, "bulk mq", peer, share, kRms))
      f.ratios.push_back({share, *value, ""});
  return f;
}

Figure compaction(const Results& results) {
  Figure f{"compact()", "garbage_collection()", "", "", Figure::Bound::at_least, 3.0, {}};
  if (const auto value = results.ratio("garbage_collection after ivdd", "compact after ivdd"))
    f.ratios.push_back({"after ivdd", *value, ""});
  return f;
}

Figure memory(const Results& results, const char* method, const char* against, double goal) {
  Figure f{std::string("peak memory, ") + method, against, "", "", Figure::Bound::at_most, goal, {}};
  f.ratios = of_planned([&](const char* m) -> std::optional<double> {
    const Json* result = results.find(long_name(method, m));
    if (!result || (*result).at("memory").is_null()) return std::nullopt;
    const double loaded = (*result).at("memory").at("loaded_bytes");
    return (*result).at("memory").at("peak_bytes").get<double>() / loaded;
  });
  return f;
}

/// Time per triangle of the model against that of the smallest model of the suite.
Figure growth(const Results& smallest, const Results& results, const char* method) {
  Figure f{std::string("growth, ") + method,
           "time per triangle on " + smallest.name(),
           "",
           "",
           Figure::Bound::at_most,
           1.5,
           {}};
  f.ratios = of_planned([&](const char* m) -> std::optional<double> {
    const auto small = smallest.seconds(long_name(method, m)), large = results.seconds(long_name(method, m));
    if (!small || !large || !(*small > 0)) return std::nullopt;
    return (*large / results.faces()) / (*small / smallest.faces());
  });
  return f;
}

}  // namespace

bool Figure::reached(const Ratio& ratio) const {
  const bool within = bound == Bound::at_least ? ratio.value >= goal : ratio.value <= goal;
  return within && ratio.remark.empty();
}

bool Figure::reached() const {
  return std::all_of(ratios.begin(), ratios.end(), [&](const Ratio& ratio) { return reached(ratio); });
}

std::vector<Figure> figures(const Json& run) {
  const bool assertions = run.at("openmesh_core").at("assertions");
  std::vector<Figure> all;
  const auto keep = [&](Figure f, const Results& results) {
    if (f.ratios.empty()) return;
    f.model = results.name();
    f.core = run.at("openmesh_core").at("label");
    all.push_back(std::move(f));
  };
  for (const Json& suite : run.at("suites")) {
    if (suite.at("suite") == "textured") continue;  // has goals of its own
    const Json& models = suite.at("models");
    for (const Json& model : models) {
      const Results results(model);
      if (suite.at("suite") == "growth") {
        if (&model == &models.front()) continue;
        const Results smallest(models.front());
        for (const char* method : {"sweep", "bulk"}) keep(growth(smallest, results, method), results);
        continue;
      }
      keep(sweep_against_stock(results, assertions), results);
      keep(sweep_against_meshopt(results), results);
      keep(bulk_against_sloppy(results), results);
      keep(lazy_against_stock(results, assertions), results);
      keep(lazy_against_meshopt(results), results);
      keep(mq_against_meshopt(results, "mq",
                              suite.at("suite") != "truth" ? 1.0
                              : results.is("dragon")       ? 0.7
                                                           : 0.8),
           results);
      keep(mq_against_meshopt(results, "mq, threads: 1", 1.0), results);
      for (const char* peer : {"CGAL Lindstrom-Turk", "meshopt_simplify", "DecimaterT quadric"})
        keep(mq_error_against(results, peer), results);
      keep(compaction(results), results);
      keep(memory(results, "sweep", "the loaded OpenMesh mesh", 1.6), results);
      keep(memory(results, "bulk", "the arrays", 2.5), results);
    }
  }
  return all;
}

std::vector<MeanRatio> mean_ratios(const Json& suite) {
  std::vector<MeanRatio> all;
  for (const char* ours : {"bulk mq", "bulk mq, not refitted"})
    for (const char* peer : {"CGAL Lindstrom-Turk", "meshopt_simplify"})
      for (const char* share : kShares)
        for (const char* which : {kRms, kMax}) {
          MeanRatio mean{ours, peer, share, which == kRms ? "RMS" : "largest distance", 1, 0, "", 0};
          double logarithms = 0;
          for (const Json& model : suite.at("models")) {
            const Results results(model);
            const auto value = error_ratio(results, ours, peer, share, which);
            if (!value) continue;
            logarithms += std::log(*value);
            ++mean.models;
            if (*value <= mean.worst) continue;
            mean.worst = *value;
            mean.worst_model = results.name();
          }
          if (mean.models < 2) continue;
          mean.geometric_mean = std::exp(logarithms / static_cast<double>(mean.models));
          all.push_back(mean);
        }
  return all;
}

}  // namespace whittle::speed
