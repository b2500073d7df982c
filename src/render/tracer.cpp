// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/tracer.hpp"

#include "mesh/surface_box.hpp"

#include <counterpart/mesh/measure.hpp>

#include <limits>
#include <utility>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace counterpart::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

void intersect(RTCScene scene, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &ray, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

void occlude(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

RTCRay make_ray(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near, float far) {
    RTCRay ray{};
    ray.org_x = origin.x(), ray.org_y = origin.y(), ray.org_z = origin.z();
    ray.dir_x = direction.x(), ray.dir_y = direction.y(), ray.dir_z = direction.z();
    ray.tnear = near, ray.tfar = far;
    ray.mask = 0xffffffff;
    return ray;
}

template <class T>
T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t size, std::size_t count) {
    return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, size, count));
}

struct Scene3 {
    RTCScene scene = nullptr;
    explicit Scene3(RTCDevice device) : scene(rtcNewScene(device)) {
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    }
    ~Scene3() { rtcReleaseScene(scene); }
    Scene3(const Scene3&) = delete;
    Scene3& operator=(const Scene3&) = delete;
};

struct Device {
    // One thread builds the tree, so that it is the same each time.
    RTCDevice device = rtcNewDevice("threads=1");
    Device() {
        if (device == nullptr) throw std::bad_alloc();
    }
    ~Device() { rtcReleaseDevice(device); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
};

}  // namespace

struct Tracer::Data {
    const Scene& scene;
    Device device;
    Scene3 visible{device.device}, solid{device.device};  // solid: what casts shadows
    std::vector<Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>> normals;
    float top = 0, size = 0;

    explicit Data(const Scene& what) : scene(what) {
        std::uint32_t id = 0;
        for (const Surface& surface : scene.surfaces) add(make_mesh(surface), id++, true);
        if (!scene.dots.empty()) add(make_dots(), id, true);
        if (!scene.tubes.empty()) add(make_tubes(), id + 1, false);
        rtcCommitScene(visible.scene);
        rtcCommitScene(solid.scene);
        RTCBounds box;
        rtcGetSceneBounds(visible.scene, &box);
        top = box.upper_z + 1;
        if (scene.surfaces.empty()) size = std::max(box.upper_x - box.lower_x, box.upper_y - box.lower_y);
    }

    void add(RTCGeometry geometry, std::uint32_t id, bool casts_shadow) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(visible.scene, geometry, id);
        if (casts_shadow) rtcAttachGeometryByID(solid.scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }

    RTCGeometry make_mesh(const Surface& surface) {
        MeshView mesh = surface.mesh;
        RTCGeometry geometry = rtcNewGeometry(device.device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                       static_cast<std::size_t>(mesh.n_vertices()));
        for (Eigen::Index i = 0; i < mesh.vertices.size(); ++i)
            vertices[i] = static_cast<float>(mesh.vertices.data()[i]);
        auto* triangles = buffer<Index>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(Index),
                                        static_cast<std::size_t>(mesh.n_triangles()));
        std::copy_n(mesh.triangles.data(), mesh.triangles.size(), triangles);
        normals.push_back(vertex_normals(mesh).cast<float>());
        size = std::max(size, static_cast<float>(counterpart::mesh::surface_box(mesh).sizes().maxCoeff()));
        return geometry;
    }

    RTCGeometry make_dots() {
        RTCGeometry geometry = rtcNewGeometry(device.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* spheres = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4 * sizeof(float),
                                      scene.dots.size());
        for (const Dot& dot : scene.dots) spheres = put(spheres, dot.center, dot.radius);
        return geometry;
    }

    RTCGeometry make_tubes() {
        RTCGeometry geometry = rtcNewGeometry(device.device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
        auto* ends = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4 * sizeof(float),
                                   2 * scene.tubes.size());
        auto* first = buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT,
                                            sizeof(std::uint32_t), scene.tubes.size());
        for (std::size_t i = 0; i < scene.tubes.size(); ++i) {
            const Tube& tube = scene.tubes[i];
            ends = put(put(ends, tube.from, tube.radius), tube.to, tube.radius);
            first[i] = static_cast<std::uint32_t>(2 * i);
        }
        return geometry;
    }

    static float* put(float* at, const Eigen::RowVector3d& center, double radius) {
        for (int c = 0; c < 3; ++c) *at++ = static_cast<float>(center[c]);
        *at++ = static_cast<float>(radius);
        return at;
    }

    Eigen::Vector3f smooth_normal(const RTCHit& hit, const Eigen::Vector3f& flat) const {
        if (hit.geomID >= normals.size()) return flat;
        const auto corners = scene.surfaces[hit.geomID].mesh.triangles.row(hit.primID);
        const auto& normal = normals[hit.geomID];
        const Eigen::Vector3f smooth = (1 - hit.u - hit.v) * normal.row(corners[0]) +
                                       hit.u * normal.row(corners[1]) + hit.v * normal.row(corners[2]);
        const float length = smooth.norm();
        return length > 1e-6F ? Eigen::Vector3f(smooth / length) : flat;
    }
};

Tracer::Tracer(const Scene& scene) : data_(std::make_unique<Data>(scene)) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Tracer::Hit Tracer::look(double x, double y) const {
    const Eigen::Vector3f origin(static_cast<float>(x), static_cast<float>(y), data_->top);
    RTCRayHit ray{make_ray(origin, -Eigen::Vector3f::UnitZ(), 0, infinity), {}};
    ray.hit.geomID = ray.hit.primID = RTC_INVALID_GEOMETRY_ID;
    intersect(data_->visible.scene, ray);
    Hit hit;
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
    hit.object = ray.hit.geomID, hit.primitive = ray.hit.primID;
    hit.u = ray.hit.u, hit.v = ray.hit.v;
    hit.position = origin - Eigen::Vector3f(0, 0, ray.ray.tfar);
    Eigen::Vector3f flat = Eigen::Vector3f(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z).normalized();
    hit.normal = data_->smooth_normal(ray.hit, flat);
    if (flat.z() < 0) {
        hit.inside = ray.hit.geomID < data_->normals.size();
        flat = -flat, hit.normal = -hit.normal;
    }
    // Near the silhouette interpolation can turn the normal away from the viewer.
    if (hit.normal.z() < 0.02F)
        hit.normal = Eigen::Vector3f(hit.normal.x(), hit.normal.y(), 0.02F).normalized();
    return hit;
}

bool Tracer::blocked(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near,
                     float far) const {
    RTCRay ray = make_ray(origin, direction, near, far);
    occlude(data_->solid.scene, ray);
    return ray.tfar < 0;
}

Color Tracer::color(const Hit& hit) const {
    const Scene& scene = data_->scene;
    if (hit.object == scene.surfaces.size()) return scene.dots[hit.primitive].color;
    if (hit.object > scene.surfaces.size()) return scene.tubes[hit.primitive].color;
    const Surface& surface = scene.surfaces[hit.object];
    const auto corners = surface.mesh.triangles.row(hit.primitive);
    const double u = static_cast<double>(hit.u), v = static_cast<double>(hit.v);
    const Eigen::RowVector3d attribute = (1 - u - v) * surface.attributes.row(corners[0]) +
                                         u * surface.attributes.row(corners[1]) +
                                         v * surface.attributes.row(corners[2]);
    return surface.color ? surface.color(attribute) : attribute;
}

float Tracer::object_size() const { return data_->size; }

}  // namespace counterpart::render
