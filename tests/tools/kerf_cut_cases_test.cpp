#include <cmath>
#include <string>

#include "tools/program.h"

// The smallest files that were once cut wrongly, each under the name of the cause.

namespace kerf::tools {
namespace {

/// A shell over the outline (0.125, 0) (0.1348581165, 1.62488128e-20) (0.1348581165, 0) (0.1330788136, 0.00131935824)
/// and four more points: the last difference does not fit into a double.
constexpr const char* kFolded =
    "v 0.125 0 -1\nv 0.134858117 1.62488128e-20 -1\nv 0.134858117 0 -1\nv 0.133078814 0.00131935824 -1\n"
    "v 0.1 0.1 -1\nv 0.02 0.1 -1\nv 0.05 0.05 -1\nv 0 0 -1\n"
    "v 0.125 0 1\nv 0.134858117 1.62488128e-20 1\nv 0.134858117 0 1\nv 0.133078814 0.00131935824 1\n"
    "v 0.1 0.1 1\nv 0.02 0.1 1\nv 0.05 0.05 1\nv 0 0 1\n"
    "v 0.07 0.03 -1.5\nv 0.07 0.03 1.5\n"
    "f 1 2 10\nf 1 10 9\nf 2 1 17\nf 9 10 18\nf 2 3 11\nf 2 11 10\nf 3 2 17\nf 10 11 18\n"
    "f 3 4 12\nf 3 12 11\nf 4 3 17\nf 11 12 18\nf 4 5 13\nf 4 13 12\nf 5 4 17\nf 12 13 18\n"
    "f 5 6 14\nf 5 14 13\nf 6 5 17\nf 13 14 18\nf 6 7 15\nf 6 15 14\nf 7 6 17\nf 14 15 18\n"
    "f 7 8 16\nf 7 16 15\nf 8 7 17\nf 15 16 18\nf 8 1 9\nf 8 9 16\nf 1 8 17\nf 16 9 18\n";

/// A box inside of it, wound as a cavity.
constexpr const char* kCavity =
    "v 0.07 0.03 -0.5\nv 0.08 0.03 -0.5\nv 0.08 0.04 -0.5\nv 0.07 0.04 -0.5\n"
    "v 0.07 0.03 0.5\nv 0.08 0.03 0.5\nv 0.08 0.04 0.5\nv 0.07 0.04 0.5\n"
    "f -8 -3 -7\nf -8 -4 -3\nf -7 -2 -6\nf -7 -3 -2\nf -6 -1 -5\nf -6 -2 -1\nf -5 -4 -8\nf -5 -1 -4\n"
    "f -8 -7 -6\nf -8 -6 -5\nf -4 -2 -3\nf -4 -1 -2\n";

/// Two tetrahedra that share all corners of their bases, and so hold one triangle twice.
constexpr const char* kCommonBase =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.2 0.2 1\nv 0.3 0.3 2\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 2\nf 1 2 5\nf 2 3 5\nf 3 1 5\n";

class KerfCutCase : public ProgramTest
{
protected:
    bool has_halfedge() const { return kerf("cut no.obj --normal 0,0,1 --out o --backend halfedge").status != 2; }
};

TEST_F(KerfCutCase, ATouchTooSmallForADifferenceIsCappedOnce)
{
    if (!has_halfedge()) GTEST_SKIP() << "this program has no half-edge back end";
    write("shell.obj", kFolded);
    write("cavity.obj", std::string(kFolded) + kCavity);
    double area = 0.0086769358;
    for (const char* file : {"shell.obj", "cavity.obj"}) {
        SCOPED_TRACE(file);
        const Json cut = kerf_json("cut " + std::string(file) + " --normal 0,0,1 --point 0,0,0 --out o");
        EXPECT_EQ(cut["status"], "cut");
        EXPECT_EQ(cut["warnings"], Json({"coarse_coordinates"}));
        EXPECT_NEAR(cut["section_area"].get<double>(), area, 1e-8);
        for (const char* side : {"positive", "negative"}) {
            EXPECT_EQ(cut[side]["closed"], true);
            EXPECT_NEAR(cut[side]["cap_area"].get<double>(), cut["section_area"].get<double>(), 1e-9);
        }
        area -= 0.01 * 0.01;  // the cavity's section
    }
}

TEST_F(KerfCutCase, ATriangleThatTwoSolidsShareOpensNeither)
{
    write("dup.obj", kCommonBase);
    const Json whole = kerf_json("info dup.obj");
    EXPECT_NEAR(whole["volume"].get<double>(), 0.5, 1e-6);
    for (const char* backend : {"", " --backend baseline"}) {
        SCOPED_TRACE(backend);
        const Json cut = kerf_json("cut dup.obj --normal 0.1,0.2,1 --point 0.2,0.2,0.5 --out o" + std::string(backend));
        EXPECT_EQ(cut["status"], "cut");
        EXPECT_EQ(cut["positive"]["closed"], true);
        EXPECT_EQ(cut["negative"]["closed"], true);
        EXPECT_NEAR(cut["negative"]["volume"].get<double>(), 0.3243, 1e-4);
        EXPECT_NEAR(cut["positive"]["volume"].get<double>() + cut["negative"]["volume"].get<double>(), 0.5, 1e-6);
    }
}

}  // namespace
}  // namespace kerf::tools
