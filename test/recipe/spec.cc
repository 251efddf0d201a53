#include "recipe/Spec.hh"
#include "catch.hh"
#include "recipe/Catalogue.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/Fass.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

using namespace whittle;
using namespace whittle::recipe;

namespace {

const Scale kScale{0.5, 20};

template <typename P>
P planner(const std::string& text, const TargetCount& target = {}) {
  const Spec spec = parse_spec(text);
  return find_module(spec.name).make_planner(spec, kScale, target).template as<P>();
}
FaceAngle fad(const std::string& text) {
  return planner<FaceAngle>(text);
}
VertexDistance ivdd(const std::string& text) {
  return planner<VertexDistance>(text);
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

  const auto vt = planner<Circumcenter>("vt:placement=circumcenter,guard=0.1,order=error");
  CHECK(vt.order == ScanOrder::error);
  CHECK(vt.placement == Circumcenter::Placement::circumcenter);
  CHECK(vt.guard.min_cos == 0.1);
  const auto ss = planner<SphereScan>("ss:radius=2e,placement=quadric");
  CHECK(ss.radius == 1);
  CHECK(ss.placement == SphereScan::Placement::quadric);
  const auto vtd = planner<Vtd>("vtd:distance=1%,fold=literal");
  CHECK(vtd.max_distance == 0.2);
  CHECK(vtd.fold == Vtd::Fold::literal);
  const auto fass = planner<Fass>("fass:radius=1,angle=20,boundary=merge,guard=0");
  CHECK(fass.face_angle.max_normal_angle == 20);
  CHECK(fass.sphere_scan.radius == 1);
  CHECK(fass.face_angle.boundary == Boundary::merge);
  CHECK(fass.sphere_scan.boundary == Boundary::merge);
  CHECK(fass.face_angle.guard.min_cos == 0);
  CHECK(fass.sphere_scan.guard.min_cos == 0);

  const auto mq = planner<MemorylessQuadric>("mq:feature=40,max-distance=1%,guard=0.5", {100, 60});
  CHECK(mq.feature_angle == 40);
  CHECK(mq.max_distance == 0.2);
  CHECK(mq.guard.min_cos == 0.5);
  CHECK(mq.target_faces == 100);
  CHECK(mq.target_vertices == 60);
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
