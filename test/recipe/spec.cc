#include "recipe/Spec.hh"
#include "catch.hh"
#include "recipe/Catalogue.hh"
#include "recipe/planner.hh"

using namespace whittle;
using namespace whittle::recipe;

namespace {

const Scale kScale{0.5, 20};

FaceAngle fad(const std::string& text) {
  return std::get<FaceAngle>(make_planner(parse_spec(text), kScale));
}
VertexDistance ivdd(const std::string& text) {
  return std::get<VertexDistance>(make_planner(parse_spec(text), kScale));
}

}  // namespace

TEST_CASE("a spec is a name with keys and values, and goes back to the same text") {
  const Spec spec = parse_spec("fad:angle=20,pairs=all");
  CHECK(spec.name == "fad");
  REQUIRE(spec.parameters.size() == 2);
  CHECK(spec.number("angle") == 20);
  CHECK(spec.word("pairs") == "all");
  CHECK_FALSE(spec.has("lock"));
  CHECK(spec.text() == "fad:angle=20,pairs=all");
  CHECK(parse_spec("quadric").text() == "quadric");
}

TEST_CASE("lengths are in model units, mean edges, or percent of the diagonal") {
  CHECK(ivdd("ivdd:distance=0.0011").max_distance == 0.0011);
  CHECK(ivdd("ivdd:distance=0.8e").max_distance == 0.4);
  CHECK(ivdd("ivdd:distance=0.5%").max_distance == 0.1);
  CHECK(ivdd("ivdd:distance=1e-3").max_distance == 0.001);
  CHECK(ivdd("ivdd:distance=1e-3e").max_distance == 0.0005);
}

TEST_CASE("every key reaches its planner") {
  CHECK(fad("fad").max_normal_angle == FaceAngle().max_normal_angle);
  CHECK(fad("fad:angle=20").max_normal_angle == 20);
  CHECK(fad("fad:included=150").max_normal_angle == 30);
  CHECK(fad("fad:pairs=all").pairs == FaceAngle::Pairs::all);
  CHECK(fad("fad:count=3").count == 3);
  CHECK(fad("fad:area=0.25").max_area == 0.25);
  CHECK(fad("fad:lock=strict").lock == FaceAngle::Lock::strict);
  CHECK(fad("fad:apex=lexicographic").apex == FaceAngle::Apex::lexicographic);
  CHECK(fad("fad:guard=-1").guard.min_cos == -1);
  CHECK(ivdd("ivdd:placement=circumcenter").placement == VertexDistance::Placement::circumcenter);
  CHECK(ivdd("ivdd:guard=0.5").guard.min_cos == 0.5);
  CHECK(ivdd("ivdd:boundary=merge").boundary == Boundary::merge);

  const auto vt =
      std::get<Circumcenter>(make_planner(parse_spec("vt:placement=circumcenter,guard=0.1"), kScale));
  CHECK(vt.placement == Circumcenter::Placement::circumcenter);
  CHECK(vt.guard.min_cos == 0.1);
  const auto ss = std::get<SphereScan>(make_planner(parse_spec("ss:radius=2e,placement=quadric"), kScale));
  CHECK(ss.radius == 1);
  CHECK(ss.placement == SphereScan::Placement::quadric);
  const auto vtd = std::get<Vtd>(make_planner(parse_spec("vtd:distance=1%,fold=literal"), kScale));
  CHECK(vtd.max_distance == 0.2);
  CHECK(vtd.fold == Vtd::Fold::literal);
  const auto fass =
      std::get<Fass>(make_planner(parse_spec("fass:radius=1,angle=20,boundary=merge,guard=0"), kScale));
  CHECK(fass.face_angle.max_normal_angle == 20);
  CHECK(fass.sphere_scan.radius == 1);
  CHECK(fass.face_angle.boundary == Boundary::merge);
  CHECK(fass.sphere_scan.guard.min_cos == 0);
}

TEST_CASE("what means nothing is refused, and the message names it") {
  using Catch::Matchers::Contains;
  const auto refused = [](const std::string& text, const std::string& culprit) {
    INFO(text);
    CHECK_THROWS_AS(parse_spec(text), RecipeError);
    CHECK_THROWS_WITH(parse_spec(text), Contains(culprit));
  };
  refused("", "unknown module ''");
  refused("fda", "unknown module 'fda'; there are vt, fad, ivdd");
  refused("fad:angel=20", "unknown key 'angel'; there are angle");
  refused("independent-sets:a=1", "it has none");
  refused("fad:angle", "'angle' is not key=value");
  refused("fad:", "is not key=value");
  refused("fad:angle=20,", "is not key=value");
  refused("fad:=20", "is not key=value");
  refused("fad:angle=", "angle= is not a number");
  refused("fad:angle=steep", "angle=steep is not a number");
  refused("fad:angle=nan", "angle=nan is not a number");
  refused("fad:angle=20deg", "angle=20deg is not a plain number");
  refused("fad:angle=181", "angle=181 is out of range; from 0 to 180");
  refused("fad:angle=-1", "angle=-1 is out of range");
  refused("fad:count=1.5", "count=1.5 is not a whole number");
  refused("fad:count=0", "out of range");
  refused("fad:pairs=some", "pairs=some is not adjacent or all");
  refused("fad:angle=1,angle=2", "key 'angle' stands twice");
  refused("ivdd:distance=1m", "unknown unit 'm'");
  refused("ivdd:distance=-1", "out of range; at least 0");
  refused("ivdd:distance=inf", "is not a number");
  refused("ivdd:distance=1e999", "is not a number");
  refused("aspect-ratio:ratio=0.5", "out of range");
  CHECK_THROWS_WITH(fad("fad:angle=20,included=160"), Contains("the same threshold"));
  CHECK_THROWS_AS(fad("fad:area=0"), RecipeError);
}

TEST_CASE("the catalogue's help names every module and key") {
  const std::string help = catalogue_help();
  for (const ModuleInfo& module : catalogue()) {
    CHECK(help.find(module.name + ":") != std::string::npos);
    for (const Key& key : module.keys) CHECK(help.find(key.name + "=") != std::string::npos);
  }
}
