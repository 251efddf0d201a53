#include "measure/ClosestFace.hh"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "measure/Monitor.hh"

namespace whittle::measure {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Added to a search radius in Embree's coordinates, relative to their size and to the radius. Rounding a
/// coordinate to float costs 6e-8 of it, Embree's own arithmetic a few times that.
constexpr double kMargin = 2e-6;

/// Beyond this many times the surface's size the margin covers the whole surface: nothing can be ruled out.
constexpr double kFar = 1e6;

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_CANCELLED) throw Cancelled();
  if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot build its tree");
}

using Nine = std::array<double, 9>;

/// The corners of a face, the least first, then the way around.
Nine canonical(const Corners& face) {
  std::array<const Eigen::Vector3d*, 3> at{&face.a, &face.b, &face.c};
  const auto is_less = [](const auto* p, const auto* q) {
    return std::lexicographical_compare(p->begin(), p->end(), q->begin(), q->end());
  };
  std::rotate(at.begin(), std::min_element(at.begin(), at.end(), is_less), at.end());
  Nine out{};
  for (std::size_t i = 0; i < 9; ++i) out[i] = (*at[i / 3])[static_cast<Eigen::Index>(i % 3)] + 0.0;  // no -0
  return out;
}

/// FNV-1a over the words.
std::uint64_t hash_of(const Nine& numbers) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const double number : numbers) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    hash = (hash ^ bits ^ bits >> 32) * 0x100000001b3u;
  }
  return hash;
}

bool ask(void* go_on, double /*part*/) {
  return (*static_cast<const std::function<bool()>*>(go_on))();
}

}  // namespace

void ClosestFace::Release::operator()(RTCDeviceTy* device) const {
  rtcReleaseDevice(device);
}
void ClosestFace::Release::operator()(RTCSceneTy* scene) const {
  rtcReleaseScene(scene);
}

ClosestFace::ClosestFace(const Surface& surface, unsigned threads, const std::function<bool()>& go_on)
    : surface_(surface) {
  find_distinct();
  constexpr double kMany = 64;  // boxes at a point, which take longer than to go down a tree of turned ones
  if (OrientedBoxes::mean_overlap(surface, faces_) > kMany)
    oriented_.emplace(surface, faces_, go_on);
  else
    build_tree(threads, go_on);
}

void ClosestFace::build_tree(unsigned threads, const std::function<bool()>& go_on) {
  const Surface& surface = surface_;
  Eigen::Vector3d low = surface.point(surface.vertices().front()), high = low;
  for (const std::uint32_t vertex : surface.vertices()) {
    low = low.cwiseMin(surface.point(vertex));
    high = high.cwiseMax(surface.point(vertex));
  }
  centre_ = low + 0.5 * (high - low);
  const double extent = (high - low).maxCoeff();
  scale_ = extent > 0 ? 1 / extent : 1;  // where all faces lie in one point

  device_.reset(rtcNewDevice(("threads=" + std::to_string(threads)).c_str()));
  if (!device_) throw std::runtime_error("Embree cannot start");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);

  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t corner_count = 3 * faces_.size();
  auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corner_count));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), faces_.size()));
  if (corner && index) {
    for (const std::uint32_t i : faces_) {
      const Corners face = surface.face(i);
      for (const auto& point : {face.a, face.b, face.c}) {
        Eigen::Map<Eigen::Vector3f> scaled(corner);
        scaled = ((point - centre_) * scale_).cast<float>();
        corner += 3;
      }
    }
    for (std::size_t i = 0; i < corner_count; ++i) index[i] = static_cast<unsigned>(i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    if (go_on)
      rtcSetSceneProgressMonitorFunction(scene_.get(), ask, const_cast<std::function<bool()>*>(&go_on));
    rtcCommitScene(scene_.get());
    rtcSetSceneProgressMonitorFunction(scene_.get(), nullptr, nullptr);
  }
  rtcReleaseGeometry(geometry);
  check(device_.get());
}

/// A tree rules out none of the faces that coincide, so it gets one of them: any number would be looked at each time.
void ClosestFace::find_distinct() {
  const std::size_t n = surface_.size();
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(n);
  for (std::size_t i = 0; i < n; ++i)
    order[i] = {hash_of(canonical(surface_.face(i))), static_cast<std::uint32_t>(i)};
  std::sort(order.begin(), order.end());
  next_.resize(n);
  std::iota(next_.begin(), next_.end(), 0u);
  std::vector<bool> is_first(n, true);
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    while (end < n && order[end].first == order[begin].first) ++end;
    std::map<Nine, std::uint32_t> last;  // faces of one hash are nearly always the same
    for (std::size_t i = begin; end - begin > 1 && i < end; ++i) {
      const std::uint32_t face = order[i].second;
      const auto [known, is_new] = last.emplace(canonical(surface_.face(face)), face);
      if (is_new) continue;
      is_first[face] = false;
      next_[known->second] = face;
      known->second = face;
    }
  }
  for (std::uint32_t i = 0; i < n; ++i)
    if (is_first[i]) faces_.push_back(i);
}

/// Calls `visit` with every distinct face that may lie within `distance`, and with its squared distance; `visit`
/// returns the distance to go on with, at most the last one.
template <typename Visit>
void ClosestFace::search(const Eigen::Vector3d& point, double distance, Visit visit) const {
  if (oriented_) {
    oriented_->search(point, distance, [&](std::uint32_t face) {
      return visit(face, (point - closest_point(point, surface_.face(face))).squaredNorm());
    });
    return;
  }
  const Eigen::Vector3d scaled = (point - centre_) * scale_;
  const double size = 1 + scaled.cwiseAbs().maxCoeff();
  const bool far = !(size < kFar);
  const auto radius = [&](double d) {
    return static_cast<float>(far ? kInfinity : d * scale_ * (1 + kMargin) + size * kMargin);
  };
  struct State {
    const Eigen::Vector3d& point;
    const Surface& surface;
    const std::vector<std::uint32_t>& faces;
    Visit& visit;
    const decltype(radius)& radius_of;
  } state{point, surface_, faces_, visit, radius};

  RTCPointQuery query{};
  if (!far) {
    query.x = static_cast<float>(scaled.x());
    query.y = static_cast<float>(scaled.y());
    query.z = static_cast<float>(scaled.z());
  }
  query.radius = radius(distance);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(
      scene_.get(), &query, &context,
      [](RTCPointQueryFunctionArguments* args) {
        auto& s = *static_cast<State*>(args->userPtr);
        const std::uint32_t face = s.faces[args->primID];
        const Eigen::Vector3d on_face = closest_point(s.point, s.surface.face(face));
        const float wanted = s.radius_of(s.visit(face, (s.point - on_face).squaredNorm()));
        if (!(wanted < args->query->radius)) return false;
        args->query->radius = wanted;
        return true;
      },
      &state);
}

ClosestFace::Answer ClosestFace::closest(const Eigen::Vector3d& point) const {
  return closest(point, {kInfinity, 0});
}

ClosestFace::Answer ClosestFace::closest(const Eigen::Vector3d& point, const Answer& known) const {
  Answer best = known;
  double distance = std::sqrt(known.squared_distance);
  search(point, distance, [&](std::size_t face, double squared) {
    if (squared < best.squared_distance) distance = std::sqrt(squared);
    if (squared < best.squared_distance || (squared == best.squared_distance && face < best.face)) {
      best = {squared, face};
    }
    return distance;
  });
  return best;
}

std::vector<std::size_t> ClosestFace::within(const Eigen::Vector3d& point, double distance) const {
  std::vector<std::size_t> faces;
  for (std::size_t face : distinct_within(point, distance)) {
    faces.push_back(face);
    for (; next_[face] != face; faces.push_back(face)) face = next_[face];
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<std::size_t> ClosestFace::distinct_within(const Eigen::Vector3d& point, double distance) const {
  std::vector<std::size_t> faces;
  search(point, distance, [&](std::size_t face, double squared) {
    if (squared <= distance * distance) faces.push_back(face);
    return distance;
  });
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace whittle::measure
