// The pieces of a cut become rigid bodies of Bullet: their mass, inertia and hulls are Kerf's.

#include <kerf/kerf.h>
#include <kerf/proxy.h>
#include <kerf/shapes.h>

#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <memory>
#include <vector>

namespace {

btVector3 to_bullet(const kerf::Vec3d& v)
{
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

struct Body
{
    kerf::Object object;
    std::unique_ptr<btConvexHullShape> shape;
    std::unique_ptr<btRigidBody> rigid;
};

/// Bullet wants the centre of mass as origin and the principal axes as axes: inertia is three numbers then.
Body body_of(kerf::Object&& object, double density)
{
    const kerf::MassProperties mass = object.mass_properties();
    const kerf::PrincipalAxes axes = kerf::principal_axes(mass.inertia_of(density));
    btMatrix3x3 rotation;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            rotation[row][column] = static_cast<btScalar>(axes.axes.m[column][row]);
    const btTransform frame(rotation, to_bullet(mass.centre));
    const btTransform to_frame = frame.inverse();

    Body body;
    body.shape = std::make_unique<btConvexHullShape>();
    const kerf::Result<kerf::Hull> hull = kerf::bounded_hull(object);
    for (const kerf::Vec3f& point : hull->points()) body.shape->addPoint(to_frame * to_bullet(point), false);
    body.shape->recalcLocalAabb();
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass.mass(density)), nullptr, body.shape.get(),
                                                  to_bullet(axes.moments));
    info.m_startWorldTransform = frame;
    body.rigid = std::make_unique<btRigidBody>(info);
    body.object = std::move(object);
    return body;
}

}  // namespace

int main()
{
    const kerf::Result<kerf::Mesh> mesh = kerf::make_shape("asteroid", 20'000);
    if (!mesh) return std::fprintf(stderr, "%s\n", mesh.reason()), 1;
    kerf::Result<kerf::Object> whole = kerf::prepare(*mesh);
    if (!whole) return std::fprintf(stderr, "%s\n", whole.reason()), 1;
    const double density = 2.0, before = whole->mass_properties().mass(density);
    kerf::CutOptions options;
    options.components = true;
    kerf::Cut cut = kerf::cut(*std::move(whole), *kerf::Plane::y(0.1), options);

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity({0, -10, 0});
    btStaticPlaneShape ground({0, 1, 0}, -3);
    btRigidBody floor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &ground));
    world.addRigidBody(&floor);

    std::vector<Body> bodies;
    double after = 0.0;
    for (const kerf::Side side : {kerf::Side::positive, kerf::Side::negative})
        for (std::size_t i = 0; kerf::Object* piece = cut.piece(side, i); ++i) {
            after += piece->mass_properties().mass(density);
            bodies.push_back(body_of(std::move(*piece), density));
            world.addRigidBody(bodies.back().rigid.get());
        }
    for (int step = 0; step < 120; ++step) world.stepSimulation(btScalar(1.0 / 60.0), 0);
    for (const Body& body : bodies) {
        const btVector3 place = body.rigid->getCenterOfMassPosition();
        std::printf("a piece of mass %.3f fell to (%.2f, %.2f, %.2f)\n", 1.0 / double(body.rigid->getInvMass()),
                    double(place.x()), double(place.y()), double(place.z()));
    }
    std::printf("mass before %.6f, after %.6f\n", before, after);
    for (const Body& body : bodies) world.removeRigidBody(body.rigid.get());
    world.removeRigidBody(&floor);
    return bodies.size() >= 2 && after > 0.999999 * before && after < 1.000001 * before ? 0 : 1;
}
