#include "viewer/game/user_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace kerf::game {
namespace {

// Puts the environment back.
class UserFolder : public testing::Test
{
protected:
    static void set(const char* name, const char* value)
    {
        if (value == nullptr) {
            ::unsetenv(name);
        } else {
            ::setenv(name, value, 1);
        }
    }
    static std::optional<std::string> value_of(const char* name)
    {
        const char* const value = std::getenv(name);
        return value == nullptr ? std::nullopt : std::optional<std::string>(value);
    }
    ~UserFolder() override
    {
        set("XDG_DATA_HOME", data_ ? data_->c_str() : nullptr);
        set("HOME", home_ ? home_->c_str() : nullptr);
    }

    const std::optional<std::string> data_ = value_of("XDG_DATA_HOME"), home_ = value_of("HOME");
};

}  // namespace

TEST_F(UserFolder, IsWhereTheUserWantsData)
{
    set("XDG_DATA_HOME", "/somewhere/data");
    EXPECT_EQ(user_folder(), "/somewhere/data/kerf");
}

TEST_F(UserFolder, IsUnderHomeOtherwise)
{
    set("HOME", "/home/ann");
    for (const char* data : {static_cast<const char*>(nullptr), "", "relative/data"}) {
        set("XDG_DATA_HOME", data);
        EXPECT_EQ(user_folder(), "/home/ann/.local/share/kerf");
    }
}

TEST_F(UserFolder, IsNowhereForUsersWithoutAHome)
{
    set("XDG_DATA_HOME", nullptr);
    set("HOME", nullptr);
    EXPECT_EQ(user_folder(), "");
}

}  // namespace kerf::game
