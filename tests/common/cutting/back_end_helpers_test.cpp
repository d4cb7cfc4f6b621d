#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "common/cutting/back_end_helpers.h"

namespace kerf::core {
namespace {

/// Materials of these names.
std::vector<Material> named(const std::vector<std::string>& names)
{
    std::vector<Material> materials(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) materials[i].name = names[i];
    return materials;
}

/// The name of the material that is added; checks that it is the last one and that the others stay.
std::string added_to(std::vector<Material> materials)
{
    const std::vector<Material> before = materials;
    EXPECT_EQ(add_cap_material(materials), before.size());
    EXPECT_EQ(materials.size(), before.size() + 1);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(materials[i].name, before[i].name);
    return materials.back().name;
}

TEST(CapMaterial, HasTheFirstNameThatIsFree)
{
    EXPECT_EQ(added_to({}), "cap");
    EXPECT_EQ(added_to(named({"", "stone", "cap.1"})), "cap");
    EXPECT_EQ(added_to(named({"cap"})), "cap.1");
    EXPECT_EQ(added_to(named({"cap.2", "cap", "cap.1", "cap.4"})), "cap.3");
    std::vector<Material> materials;
    for (std::uint32_t i = 0; i < 300; ++i) EXPECT_EQ(add_cap_material(materials), i);
    EXPECT_EQ(materials.front().name, "cap");
    EXPECT_EQ(materials[255].name, "cap.255");
    EXPECT_EQ(materials.back().name, "cap.299");
}

TEST(CapMaterial, TakesOtherSpellingsForOtherNames)
{
    EXPECT_EQ(added_to(named({"Cap", "cap ", "ca", "cape", "cap.", "cap.0", "acap"})), "cap");
    EXPECT_EQ(added_to(named({"cap", "cap.01", "cap.+1", "cap.-1", "cap.1 ", "cap.1.0", "cap1", "cap_1", "cap,1"})),
              "cap.1");
    EXPECT_EQ(
        added_to(named({"cap", "cap.4294967295", "cap.4294967296", "cap.4294967297", "cap.18446744073709551617"})),
        "cap.1");
}

TEST(CapMaterial, NeverHasANameThatIsThereHoweverOftenOthersOccur)
{
    for (const std::size_t often : {2u, 255u, 256u, 257u, 70000u}) {
        std::vector<std::string> names(often, "cap");
        names.insert(names.end(), {"cap.256", "cap.1", "cap.257", "cap.65536"});
        const std::string name = added_to(named(names));
        EXPECT_EQ(name.rfind("cap.", 0), 0u) << name;
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 0) << name;
    }
}

// Trying one name after another would look at 45 thousand million names.
TEST(CapMaterial, IsFoundAtOnceAmongManyThousandsOfItsKind)
{
    constexpr int kCount = 300'000;
    std::vector<std::string> names{"cap"};
    for (int i = 1; i < kCount; ++i) names.push_back("cap." + std::to_string(i));
    std::mt19937 random(1);
    std::shuffle(names.begin(), names.end(), random);
    EXPECT_EQ(added_to(named(names)), "cap." + std::to_string(kCount));
    std::erase(names, "cap.123456");
    EXPECT_EQ(added_to(named(names)), "cap.123456");
}

}  // namespace
}  // namespace kerf::core
