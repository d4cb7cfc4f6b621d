#include "viewer/game/fruit.h"

#include <gtest/gtest.h>

#include <set>

namespace kerf::game {

TEST(FruitCatalogue, HoldsEachKindOnce)
{
    std::set<std::string_view> names, models;
    for (const Fruit& fruit : fruit_catalogue()) {
        EXPECT_EQ(&fruit_of(fruit.kind), &fruit);
        EXPECT_EQ(find_fruit(fruit.name), fruit.kind);
        names.insert(fruit.name);
        models.insert(fruit.model);
    }
    EXPECT_EQ(names.size(), kFruitKinds);
    EXPECT_EQ(models.size(), kFruitKinds);
    EXPECT_FALSE(find_fruit("cabbage"));
}

TEST(FruitCatalogue, PaysForFruitAndNotForBombs)
{
    for (const Fruit& fruit : fruit_catalogue()) {
        EXPECT_EQ(fruit.points > 0, fruit.kind != FruitKind::bomb) << fruit.name;
        EXPECT_GT(fruit.radius, 0.5) << fruit.name << ": at 1280x720 nothing is smaller than 90 pixels across";
        EXPECT_LT(fruit.radius, 2.0) << fruit.name;
    }
}

TEST(FruitCatalogue, LeavesBombsAndSpecialsToTheirOwnRules)
{
    for (const Fruit& fruit : fruit_catalogue())
        EXPECT_EQ(fruit.weight == 0,
                  fruit.kind == FruitKind::bomb || fruit.kind == FruitKind::frozen || is_special(fruit.kind))
            << fruit.name;
}

TEST(FruitCatalogue, CallsSpecialWhatBeginsAnEffect)
{
    using enum FruitKind;
    for (const Fruit& fruit : fruit_catalogue())
        EXPECT_EQ(is_special(fruit.kind),
                  fruit.kind == freeze || fruit.kind == frenzy || fruit.kind == double_points || fruit.kind == hammer)
            << fruit.name;
}

}  // namespace kerf::game
