#include "core/render/cpu/ray_scene.h"

#include "core/base/check.h"

#include <algorithm>
#include <embree3/rtcore.h>

namespace reflectance {
namespace {

double radiusOf(const Mesh& mesh)
{
    double squared = 0.0;
    for (const Vec3d& p : mesh.positions)
        squared = std::max(squared, dot(p, p));
    return std::sqrt(squared);
}

void attachTriangles(RTCDevice device, RTCScene scene, const Mesh& mesh, RTCBuildQuality quality)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.positions.size()));
    for (const Vec3d& p : mesh.positions)
        for (const double coordinate : {p.x, p.y, p.z})
            *vertices++ = static_cast<float>(coordinate);
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Mesh::Triangle), mesh.triangles.size()));
    for (const Mesh::Triangle& triangle : mesh.triangles)
        indices = std::copy(triangle.begin(), triangle.end(), indices);
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

void setRay(RTCRay8& rays, std::size_t i, const Vec3d& origin, const Vec3d& direction, double reach)
{
    rays.org_x[i] = static_cast<float>(origin.x);
    rays.org_y[i] = static_cast<float>(origin.y);
    rays.org_z[i] = static_cast<float>(origin.z);
    rays.dir_x[i] = static_cast<float>(direction.x);
    rays.dir_y[i] = static_cast<float>(direction.y);
    rays.dir_z[i] = static_cast<float>(direction.z);
    rays.tnear[i] = 0.0F;
    rays.tfar[i] = static_cast<float>(reach);
    rays.time[i] = 0.0F;
    rays.mask[i] = 0xFFFFFFFF;
    rays.id[i] = 0;
    rays.flags[i] = 0;
}

std::array<std::uint32_t, 8> met(RTCScene scene, RTCRayHit8& rays, const int* valid)
{
    for (std::size_t i = 0; i < 8; ++i) {
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        rays.hit.primID[i] = RayScene::nothing;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcIntersect8(valid, scene, &context, &rays);

    std::array<std::uint32_t, 8> triangles{};
    for (std::size_t i = 0; i < 8; ++i)
        triangles[i] =
            valid[i] != 0 && rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? rays.hit.primID[i] : RayScene::nothing;
    return triangles;
}

} // namespace

void RayScene::Release::operator()(RTCDeviceTy* device) const
{
    rtcReleaseDevice(device);
}

void RayScene::Release::operator()(RTCSceneTy* scene) const
{
    rtcReleaseScene(scene);
}

RayScene::RayScene(std::shared_ptr<const Mesh> mesh, Tree tree)
    : mesh_(std::move(mesh)), radius_(radiusOf(*mesh_)), device_(rtcNewDevice(nullptr)),
      packetSize_(rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0 ? 16 : 8),
      scene_(rtcNewScene(device_.get()))
{
    CHECK_EQ(rtcGetDeviceError(device_.get()), RTC_ERROR_NONE);
    // Robust: no ray slips between two triangles that share an edge.
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    const RTCBuildQuality quality = tree == Tree::ForFew ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
    rtcSetSceneBuildQuality(scene_.get(), quality);
    if (!mesh_->triangles.empty())
        attachTriangles(device_.get(), scene_.get(), *mesh_, quality);
    rtcCommitScene(scene_.get());
    CHECK_EQ(rtcGetDeviceError(device_.get()), RTC_ERROR_NONE);
}

std::array<std::uint32_t, 8> RayScene::firstTriangles(const SegmentPacket& packet) const
{
    alignas(32) RTCRayHit8 rays;
    alignas(32) int valid[8];
    for (std::size_t i = 0; i < 8; ++i) {
        valid[i] = packet.active[i] ? -1 : 0;
        setRay(rays.ray, i, packet.origins[i], packet.directions[i], packet.reach[i]);
    }
    return met(scene_.get(), rays, valid);
}

} // namespace reflectance
