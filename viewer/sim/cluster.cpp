#include "viewer/sim/cluster.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <kerf/mass.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "viewer/sim/bullet_glm.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/point_inertia.h"
#include "viewer/sim/rigid_body.h"

namespace kerf::sim {

Cluster::Cluster(std::vector<Body*> members, std::vector<Bond> bonds, const Motion& motion)
    : members_(std::move(members)), bonds_(std::move(bonds))
{
    std::sort(members_.begin(), members_.end(), [](const Body* a, const Body* b) { return a->id() < b->id(); });
    const Body& first = *members_.front();
    const MeshPose pose = first.pose();
    scale_ = pose.scale;
    for (const Body* const body : members_) {
        mass_ += body->mass();
        middle_ += body->mass() * body->solid().centre;
    }
    middle_ /= mass_;
    glm::dmat3 inertia(0.0);
    for (const Body* const body : members_) {
        const glm::dvec3 arm = scale_ * (body->solid().centre - middle_);
        inertia += body->solid().inertia() + body->mass() * point_inertia(arm);
        radius_ = std::max(radius_, glm::length(arm) + body->radius());
    }
    Mat3d tensor;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) tensor.m[column][row] = inertia[column][row];
    const PrincipalAxes principal = principal_axes(tensor);
    axes_ = to_glm(principal.axes);
    moments_ = glm::dvec3(principal.moments);
    embody(pose, motion);
    for (Body* const body : members_) body->set_cluster(this);
    carry();
}

Cluster::~Cluster()
{
    for (Body* const body : members_)
        if (body->cluster() == this) body->set_cluster(nullptr);
}

void Cluster::embody(const MeshPose& pose, const Motion& motion)
{
    shape_ = std::make_unique<btCompoundShape>(true, int(members_.size()));
    const glm::dmat3 to_axes = glm::transpose(axes_);
    for (const Body* const body : members_) {
        const Solid& solid = body->solid();
        const btTransform place(to_bullet(to_axes * solid.axes),
                                to_bullet(scale_ * (to_axes * (solid.centre - middle_))));
        shape_->addChildShape(place, &body->proxy().shape());
    }
    rigid_ = make_rigid_body({mass_, moments_}, *shape_,
                             btTransform(to_bullet(pose.rotation * axes_), to_bullet(pose.to_world(middle_))));
    // Whoever asks a contact whom it belongs to is told a member: all of them came from the same cuts.
    rigid_->setUserPointer(members_.front());
    set_motion(motion);
    remember_pose();
}

glm::dvec3 Cluster::centre() const
{
    return to_glm(rigid_->getCenterOfMassPosition());
}

Motion Cluster::motion() const
{
    return {to_glm(rigid_->getLinearVelocity()), to_glm(rigid_->getAngularVelocity())};
}

void Cluster::set_motion(const Motion& motion)
{
    rigid_->setLinearVelocity(to_bullet(motion.velocity));
    rigid_->setAngularVelocity(to_bullet(motion.spin));
}

void Cluster::push(const glm::dvec3& place, const glm::dvec3& impulse)
{
    sim::push(*rigid_, place, impulse);
}

MeshPose Cluster::mesh_pose(const glm::dvec3& centre, const glm::dmat3& rotation) const
{
    MeshPose pose;
    pose.scale = scale_;
    pose.rotation = rotation * glm::transpose(axes_);
    pose.translation = centre - scale_ * (pose.rotation * middle_);
    return pose;
}

MeshPose Cluster::pose() const
{
    return mesh_pose(centre(), to_glm(rigid_->getCenterOfMassTransform().getBasis()));
}

MeshPose Cluster::pose_at(double fraction) const
{
    if (fraction >= 1.0) return pose();
    const glm::dquat from = glm::quat_cast(last_rotation_);
    const glm::dquat to = glm::quat_cast(to_glm(rigid_->getCenterOfMassTransform().getBasis()));
    return mesh_pose(glm::mix(last_centre_, centre(), fraction), glm::mat3_cast(glm::slerp(from, to, fraction)));
}

void Cluster::carry()
{
    const MeshPose here = pose();
    const Motion whole = motion();
    for (Body* const body : members_) body->be_carried(here, centre(), whole);
}

void Cluster::remember_pose()
{
    last_centre_ = centre();
    last_rotation_ = to_glm(rigid_->getCenterOfMassTransform().getBasis());
}

void Cluster::hash(StateHash& hash) const
{
    hash.add(members_.front()->id());
    hash.add(std::uint64_t(members_.size()));
    for (const Bond& bond : bonds_) {
        hash.add(bond.first);
        hash.add(bond.second);
        hash.add(bond.strength);
    }
    hash.add(centre());
    const glm::dmat3 rotation = to_glm(rigid_->getCenterOfMassTransform().getBasis());
    for (int column = 0; column < 3; ++column) hash.add(rotation[column]);
    hash.add(motion().velocity);
    hash.add(motion().spin);
}

}  // namespace kerf::sim
