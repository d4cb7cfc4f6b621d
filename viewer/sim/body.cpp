#include "viewer/sim/body.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "common/support/stopwatch.h"
#include "viewer/sim/body_proxies.h"
#include "viewer/sim/bullet_glm.h"
#include "viewer/sim/cluster.h"
#include "viewer/sim/rigid_body.h"

namespace kerf::sim {

Identity heir_of(const Identity& parent, ObjectId id, Tick birth, std::uint32_t swipe, const RecentCut& cut)
{
    Identity heir;
    heir.id = id;
    heir.parent = parent.id;
    heir.origin = parent.origin;
    heir.birth = birth;
    heir.last_swipe = swipe;
    heir.closed_rightly = parent.closed_rightly;
    for (const RecentCut& recent : parent.recent_cuts)
        if (recent.until > birth) heir.recent_cuts.push_back(recent);
    heir.recent_cuts.push_back(cut);
    return heir;
}

Body::Body(Identity identity, Object object, const Solid& solid, const MeshPose& pose, const Motion& motion,
           ProxyKind proxy)
    : identity_(std::move(identity)), object_(std::move(object)), solid_(solid)
{
    core::Stopwatch watch;
    CollisionProxy shape = body_proxy(object_, proxy);
    proxy_ms_ = watch.lap();
    embody(std::move(shape), pose, motion);
}

Body::Body(Identity identity, Object object, const Solid& solid, const MeshPose& pose, const Motion& motion,
           CollisionProxy proxy)
    : identity_(std::move(identity)), object_(std::move(object)), solid_(solid)
{
    embody(std::move(proxy), pose, motion);
}

void Body::embody(CollisionProxy proxy, const MeshPose& pose, const Motion& motion)
{
    proxy_ = std::make_unique<ProxyShape>(std::move(proxy), solid_.centre, solid_.axes, identity_.origin.scale);
    rigid_ =
        make_rigid_body({solid_.mass, solid_.moments}, proxy_->shape(),
                        btTransform(to_bullet(pose.rotation * solid_.axes), to_bullet(pose.to_world(solid_.centre))));
    set_motion(motion);
    rigid_->setUserPointer(this);
    remember_pose();
}

Body::~Body() = default;

MeshPose Body::mesh_pose(const glm::dvec3& centre, const glm::dmat3& rotation) const
{
    MeshPose pose;
    pose.scale = identity_.origin.scale;
    pose.rotation = rotation * glm::transpose(solid_.axes);
    pose.translation = centre - pose.scale * (pose.rotation * solid_.centre);
    return pose;
}

MeshPose Body::pose() const
{
    if (cluster_ != nullptr) return cluster_->pose();
    return mesh_pose(centre(), to_glm(rigid_->getCenterOfMassTransform().getBasis()));
}

MeshPose Body::pose_at(double fraction) const
{
    if (cluster_ != nullptr) return cluster_->pose_at(fraction);
    if (fraction >= 1.0) return pose();
    const glm::dquat from = glm::quat_cast(last_rotation_);
    const glm::dquat to = glm::quat_cast(to_glm(rigid_->getCenterOfMassTransform().getBasis()));
    return mesh_pose(glm::mix(last_centre_, centre(), fraction), glm::mat3_cast(glm::slerp(from, to, fraction)));
}

glm::dvec3 Body::centre() const
{
    return to_glm(rigid_->getCenterOfMassPosition());
}

Motion Body::motion() const
{
    return {to_glm(rigid_->getLinearVelocity()), to_glm(rigid_->getAngularVelocity())};
}

void Body::be_carried(const MeshPose& pose, const glm::dvec3& centre, const Motion& motion)
{
    const glm::dvec3 here = pose.to_world(solid_.centre);
    rigid_->setCenterOfMassTransform(btTransform(to_bullet(pose.rotation * solid_.axes), to_bullet(here)));
    set_motion({motion.velocity + glm::cross(motion.spin, here - centre), motion.spin});
}

void Body::set_motion(const Motion& motion)
{
    rigid_->setLinearVelocity(to_bullet(motion.velocity));
    rigid_->setAngularVelocity(to_bullet(motion.spin));
}

glm::dmat3 Body::world_inertia() const
{
    const glm::dmat3 rotation = to_glm(rigid_->getCenterOfMassTransform().getBasis());
    glm::dmat3 diagonal(0.0);
    for (int i = 0; i < 3; ++i) diagonal[i][i] = solid_.moments[i];
    return rotation * diagonal * glm::transpose(rotation);
}

glm::dvec3 Body::angular_momentum(const glm::dvec3& about) const
{
    const Motion m = motion();
    return world_inertia() * m.spin + glm::cross(centre() - about, solid_.mass * m.velocity);
}

void Body::push(const glm::dvec3& place, const glm::dvec3& impulse)
{
    sim::push(*rigid_, place, impulse);
}

void Body::add_recent_cut(const RecentCut& cut, Tick now)
{
    std::erase_if(identity_.recent_cuts, [now](const RecentCut& old) { return old.until <= now; });
    identity_.recent_cuts.push_back(cut);
}

bool Body::are_siblings(const Body& a, const Body& b, Tick now)
{
    for (const RecentCut& mine : a.identity_.recent_cuts) {
        if (now >= mine.until) continue;
        for (const RecentCut& other : b.identity_.recent_cuts)
            if (mine.cut == other.cut) return true;
    }
    return false;
}

void Body::hash(StateHash& hash) const
{
    hash.add(identity_.id);
    hash.add(identity_.parent);
    hash.add(identity_.origin.throw_number);
    hash.add(identity_.birth);
    hash.add(identity_.last_swipe);
    hash.add(missed_swipe_);
    hash.add(std::uint64_t(is_entering_));
    hash.add(object_.triangle_count());
    hash.add(solid_.mass);
    hash.add(solid_.moments);
    hash.add(centre());
    const glm::dmat3 rotation = to_glm(rigid_->getCenterOfMassTransform().getBasis());
    for (int column = 0; column < 3; ++column) hash.add(rotation[column]);
    hash.add(motion().velocity);
    hash.add(motion().spin);
}

void Body::remember_pose()
{
    last_centre_ = centre();
    last_rotation_ = to_glm(rigid_->getCenterOfMassTransform().getBasis());
}

}  // namespace kerf::sim
