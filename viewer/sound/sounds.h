#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kerf::sound {

/// Everything that can be heard. All of it is computed (synthesis.h): there are no sound files.
enum class Sound : std::uint8_t
{
    swish,       ///< the blade through air
    splat,       ///< a fruit is cut
    thud,        ///< a fruit is thrown
    miss,        ///< a fruit was missed
    fuse,        ///< a bomb is on stage; made to be repeated without a seam
    bomb,        ///< a bomb went off
    chime,       ///< a combo
    sparkle,     ///< a critical hit
    freeze,      ///< a special fruit
    extra_life,  ///< a life came back
    tick,        ///< a second of the last ten
    start,       ///< a game begins
    game_over,
    click,    ///< a button
    crack,    ///< bonds of something broke
    shatter,  ///< something fell into many pieces
};
inline constexpr std::array kAllSounds{Sound::swish,     Sound::splat,      Sound::thud,  Sound::miss,
                                       Sound::fuse,      Sound::bomb,       Sound::chime, Sound::sparkle,
                                       Sound::freeze,    Sound::extra_life, Sound::tick,  Sound::start,
                                       Sound::game_over, Sound::click,      Sound::crack, Sound::shatter};

/// "swish", "game_over".
std::string_view name_of(Sound sound);

}  // namespace kerf::sound
