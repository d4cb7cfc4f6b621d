#include "viewer/sim/breaking/breaker.h"

#include <gtest/gtest.h>

#include <set>

#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

std::shared_ptr<BreakJob> job_of(Object object, std::uint32_t cells = 20)
{
    auto job = std::make_shared<BreakJob>();
    job->object = std::move(object);
    job->options.cells = cells;
    job->scale = 2.0;
    return job;
}

}  // namespace

TEST(Breaker, MakesPiecesWithTheirMassAndProxies)
{
    Breaker breaker;
    const Object whole = test::object_of(test::shape("asteroid", 2000), backend_names().front());
    const double mass = solid_of(whole.mass_properties(), whole.bounds(), 2.0).mass;
    const auto job = job_of(test::value_of(whole.clone()));
    breaker.start(job);
    job->wait();
    ASSERT_EQ(job->status, Status::done) << job->reason;
    ASSERT_GE(job->pieces.size(), 20u);
    EXPECT_FALSE(job->bonds.empty());
    double sum = 0.0;
    for (const BrokenPiece& piece : job->pieces) {
        EXPECT_FALSE(piece.object.is_empty());
        EXPECT_FALSE(piece.proxy.points.empty());
        sum += piece.solid.mass;
    }
    EXPECT_NEAR(sum, mass, 1e-6 * mass);
}

TEST(Breaker, KeysOfPiecesAreAllDifferent)
{
    Breaker breaker;
    std::set<std::uint64_t> keys;
    std::size_t pieces = 0;
    for (int i = 0; i < 3; ++i) {
        const auto job = job_of(test::object_of(test::shape("asteroid", 500)));
        breaker.start(job);
        job->wait();
        for (const BrokenPiece& piece : job->pieces) keys.insert(piece.key);
        pieces += job->pieces.size();
    }
    EXPECT_EQ(keys.size(), pieces);
}

TEST(Breaker, StrikesWhereTheRayMeetsTheObject)
{
    Breaker breaker;
    const auto job = job_of(test::object_of(test::shape("icosphere", 1280)));
    job->options.pattern = FracturePattern::impact;
    job->ray = MeshRay{{0, 0, 9}, {0, 0, -1}};
    breaker.start(job);
    job->wait();
    ASSERT_EQ(job->status, Status::done);
    EXPECT_NEAR(job->at.z, 1.0, 0.02);
}

TEST(Breaker, GivesBackWhatTheRayMisses)
{
    Breaker breaker;
    const auto job = job_of(test::object_of(test::shape("icosphere", 1280)));
    job->ray = MeshRay{{0, 5, 9}, {0, 0, -1}};
    breaker.start(job);
    job->wait();
    EXPECT_EQ(job->status, Status::missed);
    EXPECT_TRUE(job->reason.empty()) << "that is no fault";
    EXPECT_FALSE(job->object.is_empty());
}

TEST(Breaker, GivesBackWhatIsOpenAndSaysWhy)
{
    const Mesh ball = test::shape("icosphere", 1280);
    MeshInput input = test::input_of(ball);
    input.triangle_count -= 80;
    const Mesh open = test::value_of(Mesh::make(input));
    Breaker breaker;
    const auto job = job_of(test::object_of(open));
    breaker.start(job);
    job->wait();
    EXPECT_EQ(job->status, Status::invalid_mesh);
    EXPECT_NE(job->reason.find("open"), std::string::npos);
    EXPECT_EQ(job->object.triangle_count(), open.triangle_count());
}

TEST(Breaker, EndsWhileItIsAtWork)
{
    const auto job = job_of(test::object_of(test::shape("asteroid", 50'000)), 300);
    {
        Breaker breaker;
        breaker.start(job);
    }
    // Whether it had begun or not: nobody waits for it, and nothing is lost.
    EXPECT_TRUE(!job->object.is_empty() || job->status == Status::done);
}

}  // namespace kerf::sim
