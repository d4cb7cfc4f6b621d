#include <kerf/object.h>
#include <kerf/proxy.h>

#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "api/convert.h"
#include "api/no_memory.h"
#include "common/proxy/collision_proxy.h"

namespace kerf {

struct Hull::Data
{
    std::vector<glm::vec3> points;
    std::mutex mutex;  // of what follows
    bool has_faces = false;
    std::vector<core::Triangle> faces;
};

Hull::Hull(Hull&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}

Hull& Hull::operator=(Hull&& other) noexcept
{
    Hull taken(std::move(other));
    std::swap(data_, taken.data_);
    return *this;
}

Hull::~Hull()
{
    delete data_;
}

std::span<const Vec3f> Hull::points() const noexcept
{
    if (data_ == nullptr) return {};
    return {reinterpret_cast<const Vec3f*>(data_->points.data()), data_->points.size()};
}

std::span<const std::uint32_t> Hull::indices() const noexcept
{
    if (data_ == nullptr) return {};
    const std::lock_guard lock(data_->mutex);
    if (!data_->has_faces) {
        try {
            data_->faces = core::hull_faces(data_->points);
            data_->has_faces = true;
        } catch (const std::bad_alloc&) {
            return {};  // the next call tries again
        }
    }
    if (data_->faces.empty()) return {};
    return {data_->faces.front().data(), 3 * data_->faces.size()};
}

namespace {

Result<Hull> hull_of(const Object& object, core::ProxyKind kind) noexcept
{
    if (object.is_empty()) return {Status::invalid_argument, Sentence("the object is empty: it has no hull")};
    return result_of<Hull>("there is not enough memory for the hull; free some", [&]() -> Result<Hull> {
        core::CollisionProxy proxy = core::collision_proxy(*object.inside(), kind);
        auto data = std::make_unique<Hull::Data>();
        data->points = std::move(proxy.points);
        data->has_faces = kind == core::ProxyKind::full_hull;
        data->faces = std::move(proxy.faces);
        return Hull(data.release());
    });
}

}  // namespace

Result<Hull> bounded_hull(const Object& object) noexcept
{
    return hull_of(object, core::ProxyKind::bounded_hull);
}

Result<Hull> full_hull(const Object& object) noexcept
{
    return hull_of(object, core::ProxyKind::full_hull);
}

Result<Sphere> bounding_sphere(const Object& object) noexcept
{
    if (object.is_empty()) return {Status::invalid_argument, Sentence("the object is empty: it has no sphere")};
    return result_of<Sphere>("there is not enough memory for the sphere; free some", [&]() -> Result<Sphere> {
        const core::CollisionProxy proxy = core::collision_proxy(*object.inside(), core::ProxyKind::sphere);
        return Sphere{to_public(proxy.centre), proxy.radius};
    });
}

}  // namespace kerf
