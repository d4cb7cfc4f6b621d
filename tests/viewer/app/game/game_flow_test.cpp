#include "viewer/app/game/game_flow.h"

#include <chrono>
#include <fstream>
#include <set>
#include <thread>

#include "support/temporary_folder.h"
#include "viewer/app/user_interface.h"
#include "viewer/game/game_scene.h"
#include "viewer/game/giant_scene.h"
#include "viewer/render/gl_test.h"
#include "viewer/ui/menu_scene.h"

namespace kerf::test {

using app::GameFlow;
using app::GameSetup;
using ui::MenuKey;
using ui::Screen;

namespace {

/// The game without a window, with a folder of its own for scores and settings.
class GameFlowTest : public GlTest
{
protected:
    GameSetup setup(const std::string& scene = "menu") const
    {
        GameSetup setup;
        setup.data_folder = KERF_DATA_DIR;
        setup.user_folder = folder.path();
        setup.scene = scene;
        setup.fixed_step = true;
        setup.boulder = 2000;
        return setup;
    }

    /// Draws a picture and gives what its texts cover.
    ui::Box2 picture(GameFlow& flow, int width, int height, bool with_stage = true)
    {
        if (with_stage) {
            painter.resize(width, height);
            flow.paint({});
        }
        interface.use_game_letters(width, height);
        interface.begin(width, height, 1.0 / 60.0);
        ui::Canvas canvas(interface.letters(), {width, height});
        flow.write(canvas);
        interface.draw();
        return canvas.reach();
    }

    void frames(GameFlow& flow, int count, bool with_pictures = false)
    {
        for (int i = 0; i < count; ++i) {
            flow.advance(1.0 / 60.0);
            if (with_pictures) picture(flow, 192, 108);
        }
    }

    void choose(GameFlow& flow, const std::string& label)
    {
        const auto& items = flow.screens().items();
        const bool is_menu = flow.screens().screen() == Screen::menu;
        for (std::size_t i = 0; i < 2 * items.size() && items[flow.screens().selected()].label != label; ++i) {
            if (is_menu) flow.press(MenuKey::right);
            if (!is_menu || i == items.size()) flow.press(MenuKey::down);
        }
        ASSERT_EQ(items[flow.screens().selected()].label, label);
        flow.press(MenuKey::accept);
    }

    /// In the picture that was drawn last.
    void click(GameFlow& flow, const ui::Box2& box, const glm::vec2& size)
    {
        using Kind = app::WindowPointer::Kind;
        for (const Kind kind : {Kind::move, Kind::press, Kind::release})
            flow.point({kind, glm::dvec2(box.middle())}, size);
        frames(flow, 1);
    }

    /// From the first frame of the results to the last in which nothing on them can be chosen.
    void expect_results_are_read_first(GameFlow& flow)
    {
        using Kind = app::WindowPointer::Kind;
        ASSERT_EQ(flow.screens().screen(), Screen::over);
        picture(flow, 1280, 720, false);
        const glm::dvec2 again(flow.hotspots().at(0).box.middle());
        const std::string scene = flow.scene();
        const int shown_frames = static_cast<int>(60.0 * GameFlow::kResultsShown) - 1;
        for (int frame = 0; frame < shown_frames; ++frame) {
            flow.point({Kind::press, again}, {1280.0f, 720.0f});
            flow.point({Kind::release, again}, {1280.0f, 720.0f});
            flow.press(MenuKey::accept);
            flow.press(MenuKey::back);
            flow.play_again();
            ASSERT_EQ(flow.screens().screen(), Screen::over) << "after " << frame << " frames";
            frames(flow, 1);
        }
        // A swipe that goes on beyond that, and ends on the button.
        flow.point({Kind::press, again}, {1280.0f, 720.0f});
        frames(flow, 2);
        flow.point({Kind::release, again}, {1280.0f, 720.0f});
        EXPECT_EQ(flow.screens().screen(), Screen::over);
        EXPECT_EQ(flow.scene(), scene);
    }

    void expect_texts_fit(GameFlow& flow, const std::string& what)
    {
        for (const glm::ivec2 size :
             {glm::ivec2(1280, 720), glm::ivec2(3840, 2160), glm::ivec2(700, 1200), glm::ivec2(2560, 600)}) {
            const ui::Box2 reach = picture(flow, size.x, size.y, false);
            EXPECT_LT(reach.low.x, reach.high.x) << what << " says nothing";
            const ui::Box2 whole{{0.0f, 0.0f}, glm::vec2(size)};
            EXPECT_TRUE(whole.holds(reach)) << what << " at " << size.x << "x" << size.y << ": " << reach.low.x << ","
                                            << reach.low.y << " to " << reach.high.x << "," << reach.high.y;
        }
    }

    TemporaryFolder folder;
    app::Painter painter{320, 180};
    app::UserInterface interface {
        1.0f
    };
    sound::Speaker speaker = sound::Speaker::silent();
};

}  // namespace

TEST_F(GameFlowTest, DrawsEverySceneAndScreen)
{
    for (const char* scene : {"menu", "classic", "arcade", "zen", "duel"}) {
        GameFlow flow(setup(scene), painter, speaker);
        frames(flow, 1, true);
        frames(flow, 80);
        frames(flow, 9, true);
        EXPECT_EQ(flow.scene(), scene);
    }
    GameFlow flow(setup("zen"), painter, speaker);
    for (const Screen screen : {Screen::paused, Screen::settings, Screen::scores, Screen::over, Screen::menu}) {
        flow.show_screen(screen);
        frames(flow, 4, true);
    }
}

TEST_F(GameFlowTest, AllTextsFitIntoTheSmallAndTheLargePicture)
{
    {
        GameFlow flow(setup(), painter, speaker);
        frames(flow, 30);
        expect_texts_fit(flow, "menu");
        flow.show_screen(Screen::scores);
        expect_texts_fit(flow, "scores");
        flow.show_screen(Screen::settings);
        expect_texts_fit(flow, "settings");
    }
    {
        GameFlow flow(setup("arcade"), painter, speaker);
        frames(flow, 100);
        expect_texts_fit(flow, "arcade");
        flow.show_screen(Screen::paused);
        expect_texts_fit(flow, "pause");
        flow.show_screen(Screen::over);
        expect_texts_fit(flow, "game over");
    }
    GameFlow flow(setup("duel"), painter, speaker);
    frames(flow, 60);
    expect_texts_fit(flow, "duel");
}

TEST_F(GameFlowTest, AScoreOfAnyLengthStaysOnItsCard)
{
    // The largest number that is read from a file.
    std::ofstream(folder.file("scores.json"))
        << R"({"format": "kerf-scores", "version": 1, "modes": {"classic": [{"score": 9223372036854775807,
               "date": "2026-11-21T15:08:00Z", "backend": "halfedge", "seed": 7, "fruit": 9, "longest_combo": 5}]}})";
    GameFlow flow(setup(), painter, speaker);
    ASSERT_EQ(flow.scores().best(game::GameMode::classic), 9223372036854775807);
    flow.show_screen(Screen::scores);
    const ui::Box2 reach = picture(flow, 1280, 720, false);
    constexpr float kHalfACard = 510.0f;
    EXPECT_GT(reach.low.x, 640.0f - kHalfACard * interface.letters().unit);
}

TEST_F(GameFlowTest, EveryGameIsReachedAndLeftByKeyboardAlone)
{
    GameFlow flow(setup(), painter, speaker);
    for (const char* title : {"Classic", "Arcade", "Zen", "Duel"}) {
        frames(flow, 2);
        choose(flow, title);
        frames(flow, 60);
        EXPECT_EQ(flow.screens().screen(), Screen::play) << title;
        EXPECT_EQ(ui::find_mode(flow.scene())->title, title);
        flow.press(MenuKey::back);
        EXPECT_EQ(flow.screens().screen(), Screen::paused);
        choose(flow, "Menu");
        EXPECT_EQ(flow.scene(), "menu");
    }
    choose(flow, "Quit");
    EXPECT_TRUE(flow.has_ended());
}

TEST_F(GameFlowTest, EveryGameIsPausedAndLeftByMouseAlone)
{
    for (const char* scene : {"classic", "arcade", "zen", "giant", "duel"})
        for (const glm::ivec2 pixels : {glm::ivec2(1280, 720), glm::ivec2(3840, 2160)}) {
            GameSetup small = setup(scene);
            small.giant = 10'000;
            GameFlow flow(small, painter, speaker);
            frames(flow, 10);
            const glm::vec2 size(pixels);
            picture(flow, pixels.x, pixels.y, false);
            ASSERT_EQ(flow.hotspots().size(), 1u);
            EXPECT_TRUE((ui::Box2{{0.5f * size.x, 0.0f}, size}).holds(flow.hotspots()[0].box));
            click(flow, flow.hotspots()[0].box, size);
            ASSERT_EQ(flow.screens().screen(), Screen::paused) << scene;
            picture(flow, pixels.x, pixels.y, false);
            ASSERT_EQ(flow.screens().items().back().label, "Menu");
            click(flow, flow.hotspots().back().box, size);
            EXPECT_EQ(flow.scene(), "menu") << scene;
        }
}

TEST_F(GameFlowTest, APressOnAButtonIsNoSwipeAndASwipeAcrossAButtonPressesNothing)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameFlow flow(setup("classic"), painter, speaker);
    frames(flow, 2);
    picture(flow, 1280, 720, false);
    const glm::dvec2 button(flow.hotspots().at(0).box.middle());
    flow.point({Kind::press, button - glm::dvec2(200.0, 0.0)}, size);
    flow.point({Kind::move, button}, size);
    frames(flow, 1);
    EXPECT_EQ(flow.screens().screen(), Screen::play);
    EXPECT_EQ(flow.simulation()->blade().swipe(), 1u);
    flow.point({Kind::release, button}, size);
    frames(flow, 1);
    click(flow, flow.hotspots()[0].box, size);
    EXPECT_EQ(flow.screens().screen(), Screen::paused);
    flow.press(MenuKey::back);
    frames(flow, 2);
    EXPECT_EQ(flow.simulation()->blade().swipe(), 1u);
}

TEST_F(GameFlowTest, TheGiantHasAButtonForEveryKeyThatItNames)
{
    GameSetup small = setup("giant");
    small.giant = 10'000;
    GameFlow flow(small, painter, speaker);
    frames(flow, 10);
    picture(flow, 1280, 720, false);
    const auto giants = [&] { return game::giant_of(flow.simulation()->scene())->state().giants; };
    const std::string before = flow.simulation()->backend();
    const auto giants_before = giants();
    click(flow, flow.giant()->buttons()[1], {1280.0f, 720.0f});
    frames(flow, 2);
    EXPECT_GT(giants(), giants_before);
    EXPECT_EQ(flow.simulation()->backend(), before);
    click(flow, flow.giant()->buttons()[0], {1280.0f, 720.0f});
    frames(flow, 2);
    EXPECT_NE(flow.simulation()->backend(), before);
    EXPECT_EQ(flow.simulation()->blade().swipe(), 0u);
    expect_texts_fit(flow, "giant");
}

TEST_F(GameFlowTest, FruitIsCutByKeyboardAlone)
{
    GameFlow flow(setup("zen"), painter, speaker);
    const auto cut = [&] { return game::game_of(flow.simulation()->scene())->state().counts.fruit_cut; };
    using Key = ui::BladeKey;
    // As a player who looks for a fruit, goes beside it and swipes through it.
    for (int i = 0; i < 900 && cut() == 0; ++i) {
        flow.hold(Key::cut, false);
        const auto& bodies = flow.simulation()->bodies();
        if (!bodies.empty()) {
            const glm::dvec2 aim = sim::Camera::seen_on_stage(bodies.front()->centre());
            const glm::dvec2 way = aim - flow.round().blade_input().keyboard().place();
            flow.hold(Key::right, way.x > 0.1);
            flow.hold(Key::left, way.x < -0.1);
            flow.hold(Key::up, way.y > 0.1);
            flow.hold(Key::down, way.y < -0.1);
            flow.hold(Key::cut, glm::length(way) < 2.0);
        }
        frames(flow, 1);
    }
    EXPECT_GT(cut(), 0);
}

TEST_F(GameFlowTest, APauseEndsTheKeyboardsSwipeAndTheMousePutsItsCrossAway)
{
    GameFlow flow(setup("zen"), painter, speaker);
    frames(flow, 2);
    EXPECT_FALSE(flow.round().blade_input().keyboard().is_shown());
    flow.hold(ui::BladeKey::right, true);
    flow.hold(ui::BladeKey::cut, true);
    frames(flow, 3);
    EXPECT_TRUE(flow.simulation()->blade().pressed());
    flow.pause();
    frames(flow, 2);
    flow.hold(ui::BladeKey::cut, true);
    flow.press(MenuKey::back);
    frames(flow, 2);
    EXPECT_FALSE(flow.simulation()->blade().pressed());
    EXPECT_TRUE(flow.round().blade_input().keyboard().is_shown());
    flow.hold(ui::BladeKey::cut, true);
    frames(flow, 2);
    EXPECT_EQ(flow.simulation()->blade().swipe(), 2u);
    flow.point({app::WindowPointer::Kind::press, {400.0, 300.0}}, {1280.0f, 720.0f});
    frames(flow, 2);
    EXPECT_FALSE(flow.round().blade_input().keyboard().is_shown());
    EXPECT_EQ(flow.simulation()->blade().swipe(), 3u) << "the mouse has a swipe of its own";
}

TEST_F(GameFlowTest, CuttingAFruitOfTheMenuChoosesItsGame)
{
    for (std::size_t mode = 0; mode < 3; ++mode) {
        GameFlow flow(setup(), painter, speaker);
        frames(flow, 2);
        // With the mouse, in pixels: from the lower left to the upper right of the fruit, within a tenth of a second.
        const glm::vec2 size(1280.0f, 720.0f);
        const sim::Camera camera(16.0 / 9.0);
        using Kind = app::WindowPointer::Kind;
        for (int i = 0; i <= 6; ++i) {
            const glm::dvec2 stage = ui::place_of_mode(mode) + (double(i) / 3.0 - 1.0) * glm::dvec2(1.7, 0.8);
            const glm::dvec2 pixel = camera.stage_to_screen(stage, glm::dvec2(size));
            flow.point({i == 0 ? Kind::press : i == 6 ? Kind::release : Kind::move, pixel}, size);
            frames(flow, 1);
        }
        frames(flow, 60);
        EXPECT_EQ(flow.scene(), ui::modes()[mode].scene);
    }
}

TEST_F(GameFlowTest, ClickingAWordOfTheMenuChoosesItToo)
{
    GameFlow flow(setup(), painter, speaker);
    frames(flow, 2);
    picture(flow, 1280, 720);
    const glm::dvec2 below = ui::place_of_mode(2) - glm::dvec2(0.0, ui::kModeRadius + 0.3);
    const glm::dvec2 pixel = sim::Camera(16.0 / 9.0).stage_to_screen(below, {1280.0, 720.0});
    flow.point({app::WindowPointer::Kind::press, pixel}, {1280.0f, 720.0f});
    flow.point({app::WindowPointer::Kind::release, pixel}, {1280.0f, 720.0f});
    frames(flow, 60);
    EXPECT_EQ(flow.scene(), "zen");
}

TEST_F(GameFlowTest, AGameThatIsPausedStandsStill)
{
    GameFlow flow(setup("classic"), painter, speaker);
    frames(flow, 80);
    const std::uint64_t before = flow.simulation()->state_hash();
    flow.pause();
    frames(flow, 30);
    EXPECT_EQ(flow.simulation()->state_hash(), before);
    choose(flow, "Settings");
    frames(flow, 30);
    EXPECT_EQ(flow.simulation()->state_hash(), before);
    flow.press(MenuKey::back);
    choose(flow, "Go on");
    frames(flow, 1);
    EXPECT_NE(flow.simulation()->state_hash(), before);
}

TEST_F(GameFlowTest, APauseEndsTheSwipeAndNothingOfThePauseIsPlayedBack)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameFlow flow(setup("classic"), painter, speaker);
    frames(flow, 80);
    flow.point({Kind::press, {300.0, 360.0}}, size);
    flow.point({Kind::move, {310.0, 360.0}}, size);
    frames(flow, 1);
    ASSERT_TRUE(flow.simulation()->blade().pressed());
    flow.pause();
    frames(flow, 1);
    for (int i = 0; i < 20; ++i) flow.point({Kind::move, {310.0 + 40.0 * i, 300.0 - 10.0 * i}}, size);
    flow.press(MenuKey::back);
    frames(flow, 1);
    EXPECT_FALSE(flow.simulation()->blade().pressed());
    const double farthest = sim::Camera(16.0 / 9.0).screen_to_stage({311.0, 360.0}, glm::dvec2(size)).x;
    for (const sim::TrailPoint& point : flow.simulation()->blade().trail(flow.simulation()->time()))
        EXPECT_LT(point.position.x, farthest);
}

TEST_F(GameFlowTest, NoFuseHissesDuringAPause)
{
    GameFlow flow(setup("classic"), painter, speaker);
    game::Autopilot autopilot(1);  // keeps the game going until there is a bomb
    for (int i = 0; i < 3600 && !speaker.fuse_burns(); ++i) {
        flow.let_play(autopilot);
        frames(flow, 1);
    }
    ASSERT_TRUE(speaker.fuse_burns());
    flow.pause();
    frames(flow, 1);
    EXPECT_FALSE(speaker.fuse_burns());
    flow.press(MenuKey::back);
    frames(flow, 1);
    EXPECT_TRUE(speaker.fuse_burns());
}

TEST_F(GameFlowTest, ASwipeAcrossTheMiddleOfADuelStaysInItsHalf)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameFlow flow(setup("duel"), painter, speaker);
    frames(flow, 10);
    double before = -100.0;
    for (int i = 0; i <= 8; ++i) {
        flow.point({i == 0 ? Kind::press : Kind::move, {480.0 + 40.0 * i, 360.0}}, size);
        frames(flow, 1);
        const auto trail = flow.duel()->duel().blade().trail(flow.duel()->duel().time());
        ASSERT_FALSE(trail.empty());
        EXPECT_GT(trail.back().position.x, before) << "the blade turned back at " << 480 + 40 * i;
        before = trail.back().position.x;
    }
}

TEST_F(GameFlowTest, SettingsAreThereInTheNextProgram)
{
    {
        GameFlow flow(setup(), painter, speaker);
        flow.show_screen(Screen::settings);
        for (int i = 0; i < 4; ++i) flow.press(MenuKey::left);
        flow.press(MenuKey::down);
        flow.press(MenuKey::right);
    }
    GameFlow flow(setup(), painter, speaker);
    EXPECT_NEAR(flow.settings().volume, 0.5, 1e-9);
    EXPECT_TRUE(flow.settings().mute);
    EXPECT_TRUE(speaker.muted());
}

TEST_F(GameFlowTest, SettingsAreStoredWhenTheirScreenIsLeft)
{
    GameFlow flow(setup(), painter, speaker);
    frames(flow, 2);
    flow.show_screen(Screen::settings);
    for (int i = 0; i < 4; ++i) flow.press(MenuKey::left);
    frames(flow, 2);
    EXPECT_FALSE(folder.exists("settings.json")) << "a slider that is moved does not wait for a disk";
    flow.press(MenuKey::back);
    frames(flow, 1);
    EXPECT_NEAR(game::load_settings(folder.path()).settings.volume, 0.5, 1e-9);
}

TEST_F(GameFlowTest, AGameThatIsLeftKeepsItsScore)
{
    std::int64_t score = 0;
    {
        GameFlow flow(setup("classic"), painter, speaker);
        game::Autopilot autopilot(1);
        const auto state = [&] { return game::game_of(flow.simulation()->scene())->state(); };
        for (int i = 0; i < 1200 && state().score == 0; ++i) {
            flow.let_play(autopilot);
            frames(flow, 1);
        }
        score = state().score;
        ASSERT_GT(score, 0);
        flow.press(MenuKey::back);
        choose(flow, "Menu");
        EXPECT_EQ(flow.scores().best(game::GameMode::classic), score);
        EXPECT_EQ(flow.scores().of(game::GameMode::classic).size(), 1u);
    }
    EXPECT_EQ(game::HighScores(folder.path()).best(game::GameMode::classic), score);
}

TEST_F(GameFlowTest, SaysThatTheSoundIsOffForSomeSeconds)
{
    GameFlow flow(setup(), painter, speaker);
    flow.toggle_mute();
    frames(flow, 60);
    EXPECT_EQ(flow.message(), "Sound off");
    frames(flow, 400);
    EXPECT_EQ(flow.message(), "");
}

TEST_F(GameFlowTest, SaysOfEveryDamagedFileThatItIs)
{
    for (const char* name : {"scores.json", "settings.json"}) folder.write(name, "{ torn");
    GameFlow flow(setup(), painter, speaker);
    std::set<std::string> said;
    for (int i = 0; i < 900; ++i) {
        frames(flow, 1);
        for (const char* name : {"scores.json", "settings.json"})
            if (flow.message().find(name) != std::string::npos) said.insert(name);
    }
    EXPECT_EQ(said, (std::set<std::string>{"scores.json", "settings.json"}));
    EXPECT_EQ(flow.message(), "");
}

TEST_F(GameFlowTest, AMessageIsShownWholeHoweverLongItIs)
{
    GameFlow flow(setup(), painter, speaker);
    flow.tell("/home/somebody/" + std::string(300, 'x') + "/scores.json cannot be written: no space left on device");
    expect_texts_fit(flow, "message");
    interface.begin(1280, 720, 1.0 / 60.0);
    const ui::Canvas canvas(interface.letters(), {1280.0f, 720.0f});
    for (const float width : {20.0f, 300.0f, 1100.0f}) {
        const std::string text = "a few words and \u00e4\u00f6\u00fc" + std::string(200, 'x') + " more of them";
        const std::string lines = canvas.wrapped(text, 24.0f, width);
        EXPECT_LE(canvas.measure(lines, 24.0f).x, width);
        const auto letters = [](std::string s) {
            std::erase_if(s, [](char c) { return c == ' ' || c == '\n'; });
            return s;
        };
        EXPECT_EQ(letters(lines), letters(text));
    }
    EXPECT_EQ(canvas.wrapped("short", 24.0f, 300.0f), "short");
    interface.draw();
}

TEST_F(GameFlowTest, AGameThatIsLostLeadsToItsResultsAndFromThereToTheNext)
{
    GameFlow flow(setup("classic"), painter, speaker);
    // Nobody cuts: three misses end it.
    for (int i = 0; i < 2400 && flow.screens().screen() != Screen::over; ++i) frames(flow, 1);
    ASSERT_EQ(flow.screens().screen(), Screen::over);
    expect_texts_fit(flow, "results");
    frames(flow, 60);
    choose(flow, "Play again");
    EXPECT_EQ(flow.screens().screen(), Screen::play);
    EXPECT_LT(flow.simulation()->now(), 3);
}

TEST_F(GameFlowTest, ResultsAreNotThrownAwayByWhoStillSwipesOrCutsWithSpace)
{
    GameFlow flow(setup("classic"), painter, speaker);
    for (int i = 0; i < 2400 && flow.screens().screen() != Screen::over; ++i) frames(flow, 1);
    expect_results_are_read_first(flow);
    flow.press(MenuKey::accept);
    EXPECT_EQ(flow.screens().screen(), Screen::play);
}

TEST_F(GameFlowTest, ALineIsChosenByPressingAndLettingGoOnIt)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameFlow flow(setup("zen"), painter, speaker);
    frames(flow, 2);
    flow.pause();
    picture(flow, 1280, 720, false);
    const glm::dvec2 go_on(flow.hotspots().at(0).box.middle()), menu(flow.hotspots().back().box.middle());
    const auto drag = [&](const glm::dvec2& from, const glm::dvec2& to) {
        flow.point({Kind::press, from}, size);
        flow.point({Kind::move, to}, size);
        flow.point({Kind::release, to}, size);
        frames(flow, 1);
    };
    drag(menu, {5.0, 5.0});
    drag({5.0, 5.0}, menu);
    drag(menu, go_on);
    EXPECT_EQ(flow.screens().screen(), Screen::paused);
    flow.point({Kind::press, go_on}, size);
    flow.press(MenuKey::back);
    flow.pause();
    picture(flow, 1280, 720, false);
    flow.point({Kind::release, go_on}, size);
    EXPECT_EQ(flow.screens().screen(), Screen::paused) << "what was pressed is another screen's";
    drag(go_on, go_on);
    EXPECT_EQ(flow.screens().screen(), Screen::play);
}

TEST_F(GameFlowTest, APressIsNotForTheScreenThatWasShownBefore)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameFlow flow(setup("zen"), painter, speaker);
    frames(flow, 2);
    flow.show_screen(Screen::over);
    picture(flow, 1280, 720, false);
    const glm::dvec2 again(flow.hotspots().at(0).box.middle());
    // All within a frame: the second press is where "Play again" was, and not on the button that pauses.
    for (const Kind kind : {Kind::press, Kind::release, Kind::press}) flow.point({kind, again}, size);
    EXPECT_EQ(flow.screens().screen(), Screen::play);
    frames(flow, 1);
    EXPECT_TRUE(flow.simulation()->blade().pressed()) << "it begins a swipe";
}

// In real time: no frame waits for the thread that makes the giant, and none uploads more of it than is allowed.
TEST_F(GameFlowTest, AGiantArrivesWithoutHoldingUpAFrameAndShowsHowFarItIs)
{
    GameSetup real_time = setup("giant");
    real_time.fixed_step = false;
    real_time.giant = 300'000;
    GameFlow flow(real_time, painter, speaker);
    const auto state = [&] { return game::giant_of(flow.simulation()->scene())->state(); };
    const std::uint64_t budget = app::GpuWorld::kBytesInAFrame;
    std::uint64_t uploaded = 0;
    double progress = 0.0;
    int uploading = 0;
    for (int frame = 0; frame < 100'000 && !state().is_held; ++frame) {
        flow.advance(1.0 / 60.0);
        if (state().is_held) break;
        flow.sync();
        const std::uint64_t bytes = painter.world().store().bytes_uploaded();
        EXPECT_LE(bytes - uploaded, budget);
        if (bytes > uploaded) ++uploading;
        uploaded = bytes;
        ASSERT_TRUE(flow.giant_progress());
        EXPECT_GE(*flow.giant_progress(), progress);
        progress = *flow.giant_progress();
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    ASSERT_TRUE(state().is_held);
    EXPECT_EQ(progress, 1.0);
    EXPECT_GE(uploading, 3);
    EXPECT_GT(uploaded, 2 * budget);
    // It is seen in the frame in which it appears, and costs nothing more.
    flow.sync();
    EXPECT_EQ(painter.world().store().bytes_uploaded(), uploaded);
    EXPECT_FALSE(flow.giant_progress());
}

TEST_F(GameFlowTest, FruitIsReadyBeforeItsFirstThrow)
{
    GameFlow flow(setup(), painter, speaker);
    frames(flow, 3);
    choose(flow, "Classic");
    frames(flow, 600);
    ASSERT_EQ(flow.scene(), "classic");
    ASSERT_FALSE(game::game_of(flow.simulation()->scene())->events().empty());
    EXPECT_EQ(flow.models().late_work().preparations, 0u);
}

TEST_F(GameFlowTest, ShowsANewPlayerHowToCutUntilHeDoes)
{
    const auto is_shown = [](const GameFlow& flow) { return flow.round().demo_blade() != nullptr; };
    GameFlow flow(setup("zen"), painter, speaker);
    int shown = 0;
    for (int i = 0; i < 200; ++i) {
        frames(flow, 1);
        shown += is_shown(flow) ? 1 : 0;
    }
    EXPECT_GT(shown, 10);
    EXPECT_TRUE(flow.simulation()->cuts().empty()) << "it is only shown";
    game::Autopilot autopilot(1);
    for (int i = 0; i < 200; ++i) {
        flow.let_play(autopilot);
        frames(flow, 1);
    }
    ASSERT_GT(game::game_of(flow.simulation()->scene())->state().counts.fruit_cut, 0);
    for (int i = 0; i < 200; ++i) {
        frames(flow, 1);
        EXPECT_FALSE(is_shown(flow));
    }
}

TEST_F(GameFlowTest, TheMenuShowsHowToCutHoweverLongTheGameBeforeWas)
{
    using Kind = app::WindowPointer::Kind;
    GameFlow flow(setup("zen"), painter, speaker);
    frames(flow, 600);
    flow.point({Kind::press, {100.0, 100.0}}, {1280.0f, 720.0f});
    flow.point({Kind::release, {120.0, 100.0}}, {1280.0f, 720.0f});
    flow.press(MenuKey::back);
    choose(flow, "Menu");
    int shown = 0;
    for (int i = 0; i < 100; ++i) {
        frames(flow, 1);
        shown += flow.round().demo_blade() != nullptr ? 1 : 0;
    }
    EXPECT_GT(shown, 10);
}

TEST_F(GameFlowTest, ADuelEndsWithAResultAndLeadsToARematch)
{
    GameSetup small = setup("duel");
    small.boulder = 1000;
    GameFlow flow(small, painter, speaker);
    game::Autopilot autopilot(1);
    for (int i = 0; i < 4000 && flow.screens().screen() == Screen::play; ++i) {
        flow.let_play(autopilot);
        frames(flow, 1);
    }
    ASSERT_EQ(flow.screens().screen(), Screen::over);
    EXPECT_GE(flow.duel()->now(), duel::TimetableScene::kLength);
    EXPECT_LE(flow.duel()->now(), duel::TimetableScene::kLength + 2);
    for (const duel::Score& score : flow.duel()->scores()) EXPECT_GE(score.cuts, 20u) << score.backend;
    expect_texts_fit(flow, "duel's end");
    expect_results_are_read_first(flow);
    flow.play_again();
    EXPECT_EQ(flow.screens().screen(), Screen::play);
    EXPECT_EQ(flow.scene(), "duel");
    EXPECT_EQ(flow.duel()->now(), 0);
    flow.play_again();
    EXPECT_EQ(flow.screens().screen(), Screen::play) << "only a game that is over begins anew";
}

TEST_F(GameFlowTest, ADuelGivesTheSameStatesEveryTime)
{
    std::array<std::uint64_t, 2> hashes{};
    for (int run = 0; run < 2; ++run) {
        GameFlow flow(setup("duel"), painter, speaker);
        std::vector<sim::InputEvent> swipe{{2'150'000, sim::InputKind::press, {-6.5, 1.7}, {}}};
        for (int i = 1; i < 20; ++i)
            swipe.push_back({2'150'000 + 5000 * i, sim::InputKind::move, {-6.5 + 0.65 * i, 1.8}, {}});
        swipe.push_back({2'250'000, sim::InputKind::release, {6.5, 1.9}, {}});
        flow.push(swipe);
        frames(flow, 150);
        for (std::size_t i = 0; i < 2; ++i) {
            const sim::Simulation& half = flow.duel()->duel().half(i).simulation();
            EXPECT_EQ(half.now(), 300);
            EXPECT_GE(half.cuts().size(), 1u);
            if (run == 1) {
                EXPECT_EQ(half.state_hash(), hashes[i]);
            }
            hashes[i] = half.state_hash();
        }
    }
    EXPECT_NE(hashes[0], hashes[1]) << "each half names its back end";
}

}  // namespace kerf::test
