#include "viewer/ui/screens.h"

#include <gtest/gtest.h>

#include <set>

namespace kerf::test {

using ui::MenuKey;
using ui::Request;
using ui::Screen;
using ui::Screens;

namespace {

Screens screens()
{
    return {{}, {"halfedge", "baseline/hash"}};
}

/// Presses the arrow until the line is chosen, then accepts it.
std::optional<Request> choose(Screens& s, const std::string& label)
{
    for (std::size_t i = 0; i < 2 * s.items().size() && s.items()[s.selected()].label != label; ++i) {
        if (s.screen() == Screen::menu) s.press(MenuKey::right);
        if (s.screen() != Screen::menu || i == s.items().size()) s.press(MenuKey::down);
    }
    EXPECT_EQ(s.items()[s.selected()].label, label);
    return s.press(MenuKey::accept);
}

}  // namespace

TEST(Screens, BeginWithTheMenuAndItsFirstGame)
{
    Screens s = screens();
    EXPECT_EQ(s.screen(), Screen::menu);
    EXPECT_EQ(s.press(MenuKey::accept), (Request{Request::Kind::start, "classic"}));
}

TEST(Screens, EveryModeStartsByKeyboardAlone)
{
    std::set<std::string> started;
    for (const ui::Mode& mode : ui::modes()) {
        Screens s = screens();
        const std::optional<Request> request = choose(s, std::string(mode.title));
        ASSERT_TRUE(request);
        EXPECT_EQ(request->kind, Request::Kind::start);
        started.insert(request->scene);
    }
    EXPECT_EQ(started, (std::set<std::string>{"classic", "arcade", "zen", "giant", "duel"}));
}

TEST(Screens, EveryScreenIsReachedAndLeftByKeyboardAlone)
{
    Screens s = screens();
    EXPECT_FALSE(choose(s, "High scores"));
    EXPECT_EQ(s.screen(), Screen::scores);
    EXPECT_FALSE(s.press(MenuKey::back));
    EXPECT_EQ(s.screen(), Screen::menu);
    EXPECT_FALSE(choose(s, "Settings"));
    EXPECT_EQ(s.screen(), Screen::settings);
    EXPECT_FALSE(choose(s, "Back"));
    EXPECT_EQ(s.screen(), Screen::menu);

    s.play("zen");
    EXPECT_EQ(s.screen(), Screen::play);
    s.press(MenuKey::back);
    EXPECT_EQ(s.screen(), Screen::paused);
    choose(s, "Settings");
    EXPECT_EQ(s.screen(), Screen::settings);
    s.press(MenuKey::back);
    EXPECT_EQ(s.screen(), Screen::paused) << "settings lead back to where they were asked for";
    EXPECT_EQ(choose(s, "Go on"), Request{Request::Kind::resume});
    EXPECT_EQ(s.screen(), Screen::play);
    s.show(Screen::over);
    choose(s, "High scores");
    s.press(MenuKey::back);
    EXPECT_EQ(s.screen(), Screen::over);
    EXPECT_EQ(choose(s, "Play again"), (Request{Request::Kind::restart, "zen"}));
    EXPECT_EQ(choose(s, "Menu"), Request{Request::Kind::to_menu});
    EXPECT_EQ(s.screen(), Screen::menu);
    EXPECT_EQ(choose(s, "Quit"), Request{Request::Kind::quit});
}

TEST(Screens, TheMenusRowsAreCrossedUpAndDownAndWalkedLeftAndRight)
{
    Screens s = screens();
    const auto after = [&](std::initializer_list<MenuKey> keys) {
        for (const MenuKey key : keys) s.press(key);
        return s.items()[s.selected()].label;
    };
    EXPECT_EQ(after({MenuKey::right}), "Arcade");
    EXPECT_EQ(after({MenuKey::left, MenuKey::left}), "Duel") << "round and round in a row";
    EXPECT_EQ(after({MenuKey::down}), "High scores");
    EXPECT_EQ(after({MenuKey::left}), "Quit");
    EXPECT_EQ(after({MenuKey::left}), "Settings");
    EXPECT_EQ(after({MenuKey::up}), "Duel") << "back to where it came from";
    EXPECT_EQ(after({MenuKey::right, MenuKey::up}), "High scores");
    EXPECT_EQ(after({MenuKey::down, MenuKey::right, MenuKey::right, MenuKey::down}), "High scores");
    s.press(MenuKey::back);
    EXPECT_EQ(after({}), "Quit");
    EXPECT_EQ(after({MenuKey::up}), "Zen");
}

TEST(Screens, NoGameThatWasPlayedLeadsToQuitByUpOrDown)
{
    for (const ui::Mode& mode : ui::modes())
        for (const MenuKey key : {MenuKey::up, MenuKey::down}) {
            Screens s = screens();
            s.play(std::string(mode.scene));
            s.show(Screen::menu);
            s.press(key);
            EXPECT_EQ(s.items()[s.selected()].label, "High scores") << mode.title;
        }
}

TEST(Screens, ADuelThatIsOverLeadsToARematchOrToTheMenu)
{
    Screens s = screens();
    s.play("duel");
    s.show(Screen::over);
    ASSERT_EQ(s.items().size(), 2u) << "duels have no high scores";
    EXPECT_EQ(s.press(MenuKey::accept), (Request{Request::Kind::restart, "duel"}));
    EXPECT_EQ(choose(s, "Menu"), Request{Request::Kind::to_menu});
    EXPECT_EQ(s.screen(), Screen::menu);
}

TEST(Screens, TheButtonThatPausesIsForThePointerOnly)
{
    Screens s = screens();
    s.play("zen");
    EXPECT_FALSE(s.press(MenuKey::accept));
    EXPECT_EQ(s.screen(), Screen::play);
    EXPECT_FALSE(s.click(0));
    EXPECT_EQ(s.screen(), Screen::paused);
}

TEST(Screens, EscapeNeverEndsTheProgramOrAGameByItself)
{
    Screens s = screens();
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(s.press(MenuKey::back));
    EXPECT_EQ(s.screen(), Screen::menu);
    s.play("classic");
    s.press(MenuKey::back);
    EXPECT_EQ(s.press(MenuKey::back), Request{Request::Kind::resume});
    EXPECT_EQ(s.screen(), Screen::play);
}

TEST(Screens, BackLeadsToTheLineThatWasChosen)
{
    Screens s = screens();
    choose(s, "High scores");
    s.press(MenuKey::back);
    EXPECT_EQ(s.items()[s.selected()].label, "High scores");
    s.play("zen");
    s.show(Screen::over);
    choose(s, "High scores");
    s.press(MenuKey::accept);
    EXPECT_EQ(s.items()[s.selected()].label, "High scores");
}

TEST(Screens, TheMenuChoosesWhatWasPlayedLast)
{
    Screens s = screens();
    s.play("zen");
    EXPECT_EQ(s.settings().scene, "zen");
    s.show(Screen::menu);
    EXPECT_EQ(s.items()[s.selected()].label, "Zen");
    s.play("report");
    EXPECT_EQ(s.settings().scene, "zen") << "the menu has no such line";
}

TEST(Screens, ArrowsGoRoundAndRound)
{
    Screens s = screens();
    s.play("zen");
    s.show(Screen::paused);
    s.press(MenuKey::up);
    EXPECT_EQ(s.selected(), s.items().size() - 1);
    s.press(MenuKey::right);
    EXPECT_EQ(s.selected(), 0u);
}

TEST(Screens, SettingsChangeByArrowsAndStayWithinBounds)
{
    Screens s = screens();
    s.show(Screen::settings);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(s.press(MenuKey::right), Request{Request::Kind::settings});
    EXPECT_DOUBLE_EQ(s.settings().volume, 1.0);
    for (int i = 19; i >= 0; --i) {
        s.press(MenuKey::left);
        EXPECT_EQ(s.settings().volume, double(5 * i) / 100.0) << "what is shown: whole percents";
    }
    for (int i = 0; i < 50; ++i) s.press(MenuKey::left);
    EXPECT_DOUBLE_EQ(s.settings().volume, 0.0);
    s.press(MenuKey::down);
    s.press(MenuKey::accept);
    EXPECT_TRUE(s.settings().mute);
    s.press(MenuKey::down);
    EXPECT_EQ(s.settings().backend, "halfedge");
    s.press(MenuKey::right);
    EXPECT_EQ(s.settings().backend, "baseline/hash");
    s.press(MenuKey::right);
    EXPECT_EQ(s.settings().backend, "halfedge");
    s.press(MenuKey::down);
    s.press(MenuKey::right);
    EXPECT_TRUE(s.settings().fullscreen);
    s.press(MenuKey::down);
    for (int i = 0; i < 50; ++i) s.press(MenuKey::right);
    EXPECT_DOUBLE_EQ(s.settings().window_scale, ui::kLargestWindow);
    for (int i = 0; i < 50; ++i) s.press(MenuKey::left);
    EXPECT_DOUBLE_EQ(s.settings().window_scale, ui::kSmallestWindow);
    s.press(MenuKey::down);
    s.press(MenuKey::left);
    EXPECT_FALSE(s.settings().vsync);
}

TEST(Screens, ThePointerDoesWhatTheKeysDo)
{
    Screens s = screens();
    s.point_at(2);
    EXPECT_EQ(s.selected(), 2u);
    EXPECT_EQ(s.click(1), (Request{Request::Kind::start, "arcade"}));
    s.show(Screen::settings);
    EXPECT_EQ(s.click(0, 0.52), Request{Request::Kind::settings});
    EXPECT_NEAR(s.settings().volume, 0.5, 1e-9);
    s.click(1);
    EXPECT_TRUE(s.settings().mute);
    EXPECT_FALSE(s.click(99));
    s.point_at(99);
    EXPECT_LT(s.selected(), s.items().size());
}

TEST(Screens, SettingsThatMakeNoSenseAreMended)
{
    game::StoredSettings odd;
    odd.volume = -3.0;
    odd.window_scale = 1e9;
    odd.backend = "magic";
    const Screens s(odd, {"halfedge", "baseline/hash"});
    EXPECT_EQ(s.settings().volume, 0.0);
    EXPECT_EQ(s.settings().window_scale, ui::kLargestWindow);
    EXPECT_EQ(s.settings().backend, "halfedge");
}

}  // namespace kerf::test
