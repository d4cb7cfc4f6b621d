#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "viewer/sim/body.h"
#include "viewer/sim/pose.h"
#include "viewer/sim/state_hash.h"

class btCompoundShape;
class btRigidBody;

namespace kerf::sim {

/// What holds two bodies of a cluster together.
struct Bond
{
    ObjectId first = 0, second = 0;
    double strength = 0.0;  ///< the largest impulse that it passes on, N s
};

/// Pieces of one object that still hang together: they move as one rigid body, and each is drawn, hit and cut as the body
/// that it is. All have the mesh coordinates of the object that they are pieces of, so one pose stands for all of them,
/// bit for bit: no crack is seen where nothing has parted.
class Cluster
{
public:
    /// @param members  pieces of one object with the pose that they have in common; two or more; each outlives this
    /// @param bonds    between them
    /// @param motion   of their common centre of mass
    /// O(members).
    Cluster(std::vector<Body*> members, std::vector<Bond> bonds, const Motion& motion);
    ~Cluster();
    Cluster(const Cluster&) = delete;
    Cluster& operator=(const Cluster&) = delete;

    /// In the order of their ids.
    std::span<Body* const> members() const { return members_; }
    std::span<const Bond> bonds() const { return bonds_; }

    double mass() const { return mass_; }
    glm::dvec3 centre() const;  ///< of mass, in the world, metres
    Motion motion() const;
    void set_motion(const Motion& motion);
    /// Deals it an impulse at a place of the world, N s.
    void push(const glm::dvec3& place, const glm::dvec3& impulse);
    /// Of a ball around the centre that holds all members, metres.
    double radius() const { return radius_; }
    /// Of the mesh coordinates that all members share.
    MeshPose pose() const;
    /// The same between the last tick (0) and now (1).
    MeshPose pose_at(double fraction) const;

    /// Takes the members along: to where this is now, with its motion.
    void carry();
    /// Remembers the present pose as that of the last tick.
    void remember_pose();

    /// Everything that its future depends on but the members, bit for bit.
    void hash(StateHash& hash) const;
    btRigidBody& rigid_body() const { return *rigid_; }

private:
    MeshPose mesh_pose(const glm::dvec3& centre, const glm::dmat3& rotation) const;
    void embody(const MeshPose& pose, const Motion& motion);

    std::vector<Body*> members_;
    std::vector<Bond> bonds_;
    double scale_ = 1.0;       ///< metres a mesh unit
    double mass_ = 0.0;        ///< kg
    double radius_ = 0.0;      ///< metres
    glm::dvec3 middle_{0.0};   ///< centre of mass, mesh coordinates
    glm::dmat3 axes_{1.0};     ///< principal ones, mesh coordinates
    glm::dvec3 moments_{0.0};  ///< kg m^2
    std::unique_ptr<btCompoundShape> shape_;
    std::unique_ptr<btRigidBody> rigid_;
    glm::dvec3 last_centre_{0.0};
    glm::dmat3 last_rotation_{1.0};
};

}  // namespace kerf::sim
