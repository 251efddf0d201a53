#include "measure/ClosestFace.hh"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

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
  Eigen::Vector3d low = surface.point(surface.vertices().front()), high = low;
  for (const std::uint32_t vertex : surface.vertices()) {
    low = low.cwiseMin(surface.point(vertex));
    high = high.cwiseMax(surface.point(vertex));
  }
  centre_ = low + 0.5 * (high - low);
  scale_ = 1 / (high - low).maxCoeff();

  device_.reset(rtcNewDevice(("threads=" + std::to_string(threads)).c_str()));
  if (!device_) throw std::runtime_error("Embree cannot start");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);

  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t corner_count = 3 * surface.size();
  auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corner_count));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), surface.size()));
  if (corner && index) {
    for (std::size_t i = 0; i < surface.size(); ++i) {
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

/// Calls `visit` with every face that may lie within `distance`, and with its squared distance; `visit`
/// returns the distance to go on with, at most the last one.
template <typename Visit>
void ClosestFace::search(const Eigen::Vector3d& point, double distance, Visit visit) const {
  const Eigen::Vector3d scaled = (point - centre_) * scale_;
  const double size = 1 + scaled.cwiseAbs().maxCoeff();
  const bool far = !(size < kFar);
  const auto radius = [&](double d) {
    return static_cast<float>(far ? kInfinity : d * scale_ * (1 + kMargin) + size * kMargin);
  };
  struct State {
    const Eigen::Vector3d& point;
    const Surface& surface;
    Visit& visit;
    const decltype(radius)& radius_of;
  } state{point, surface_, visit, radius};

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
        const Eigen::Vector3d on_face = closest_point(s.point, s.surface.face(args->primID));
        const float wanted = s.radius_of(s.visit(args->primID, (s.point - on_face).squaredNorm()));
        if (!(wanted < args->query->radius)) return false;
        args->query->radius = wanted;
        return true;
      },
      &state);
}

ClosestFace::Answer ClosestFace::closest(const Eigen::Vector3d& point) const {
  Answer best{kInfinity, 0};
  double distance = kInfinity;
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
  search(point, distance, [&](std::size_t face, double squared) {
    if (squared <= distance * distance) faces.push_back(face);
    return distance;
  });
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace whittle::measure
