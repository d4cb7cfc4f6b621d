#include "viewer/sim/script.h"

#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <ostream>
#include <sstream>

#include "common/files/output_file.h"
#include "common/files/read_file.h"
#include "common/support/reason.h"

namespace kerf::sim {
namespace {

constexpr std::string_view kMagic = "kerf-script";
constexpr int kVersion = 1;
/// No run is longer, microseconds: a day. Times beyond are typing errors, and would overflow when counted in ticks.
constexpr Microseconds kLatest = 86'400'000'000;
/// No place is farther from the middle of the stage, metres.
constexpr double kFarthest = 1e6;

std::string_view word_of(InputKind kind)
{
    switch (kind) {
        case InputKind::press:
            return "press";
        case InputKind::move:
            return "move";
        case InputKind::release:
            return "release";
        case InputKind::command:
            return "command";
    }
    return "command";
}

std::string_view take_word(std::string_view& rest)
{
    const std::size_t begin = std::min(rest.find_first_not_of(" \t\r"), rest.size());
    const std::size_t end = std::min(rest.find_first_of(" \t\r", begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

template <class Number>
bool parse(std::string_view word, Number& number)
{
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

class Reader
{
public:
    explicit Reader(const std::string& name) : name_(name) {}

    Script read(std::istream& in)
    {
        std::string line;
        while (std::getline(in, line)) {
            ++line_;
            const std::string_view text = trimmed(line);
            if (text.empty() || text.front() == '#') continue;
            if (!started_) {
                first_line(text);
            } else {
                statement(text);
            }
        }
        if (in.bad()) fail("reading failed");
        if (!started_) fail("this is no script: the first line must be '" + std::string(kMagic) + " 1'");
        return std::move(script_);
    }

private:
    [[noreturn]] void fail(const std::string& reason) const
    {
        const std::string place = line_ > 0 ? ":" + std::to_string(line_) : std::string();
        throw core::io::FileError(name_ + place + ": " + reason);
    }

    void first_line(std::string_view text)
    {
        int version = 0;
        if (take_word(text) != kMagic || !parse(take_word(text), version) || !trimmed(text).empty())
            fail("this is no script: the first line must be '" + std::string(kMagic) + " 1'");
        if (version != kVersion)
            fail("script version " + std::to_string(version) + " is not known, only " + std::to_string(kVersion));
        started_ = true;
    }

    void statement(std::string_view text)
    {
        std::string_view rest = text;
        const std::string_view word = take_word(rest);
        rest = trimmed(rest);
        if (word.front() >= '0' && word.front() <= '9') return event(word, rest);
        if (!script_.events.empty()) fail(core::in_quotes(word) + " must come before the first event");
        if (rest.empty()) fail(core::in_quotes(word) + " needs a value");
        if (word == "scene") {
            script_.scene = rest;
        } else if (word == "backend") {
            script_.backend = rest;
        } else if (word == "proxy") {
            script_.proxy = rest;
        } else if (word == "seed") {
            std::uint64_t seed = 0;
            if (!parse(rest, seed)) fail(core::in_quotes(rest) + " is no seed: a whole number from 0 to 2^64 - 1");
            script_.seed = seed;
        } else {
            fail(core::in_quotes(word) + " is not known: scene, backend, proxy, seed, or a time");
        }
    }

    void event(std::string_view word, std::string_view rest)
    {
        InputEvent event;
        if (!parse(word, event.time) || event.time > kLatest)
            fail(core::in_quotes(word) + " is no time: whole microseconds, at most a day");
        if (!script_.events.empty() && event.time < script_.events.back().time) fail("time goes backwards");
        while (at_once_ < script_.events.size() && script_.events[at_once_].time <= event.time - kAtOnce) ++at_once_;
        if (script_.events.size() - at_once_ >= kMostEventsAtOnce)
            fail("more than " + std::to_string(kMostEventsAtOnce) +
                 " events within a quarter of a second; leave some out");
        const std::string_view kind = take_word(rest);
        rest = trimmed(rest);
        bool known = false;
        for (const InputKind candidate : {InputKind::press, InputKind::move, InputKind::release, InputKind::command}) {
            if (kind != word_of(candidate)) continue;
            event.kind = candidate;
            known = true;
        }
        if (!known) fail(core::in_quotes(kind) + " is not known: press, move, release or command");
        if (event.kind == InputKind::command) {
            if (rest.empty()) fail("'command' needs a text");
            event.text = rest;
        } else {
            event.position.x = coordinate(take_word(rest));
            event.position.y = coordinate(take_word(rest));
            if (!trimmed(rest).empty()) fail(core::in_quotes(kind) + " takes two numbers and nothing else");
        }
        script_.events.push_back(std::move(event));
    }

    double coordinate(std::string_view word) const
    {
        double value = 0.0;
        if (!parse(word, value) || !(std::abs(value) <= kFarthest))
            fail(core::in_quotes(word) + " is no place on the stage: two numbers in metres are needed");
        return value;
    }

    const std::string& name_;
    std::size_t line_ = 0;
    std::size_t at_once_ = 0;  ///< the first event within kAtOnce of the last
    bool started_ = false;
    Script script_;
};

std::string shortest(double value)
{
    std::array<char, 32> digits;
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), result.ptr};
}

}  // namespace

Script read_script(std::istream& in, const std::string& name)
{
    return Reader(name).read(in);
}

Script read_script(const std::filesystem::path& path)
{
    std::istringstream in(core::io::read_bytes(path));
    return read_script(in, path.string());
}

void write_script(std::ostream& out, const Script& script)
{
    out << kMagic << ' ' << kVersion << '\n';
    if (!script.scene.empty()) out << "scene " << script.scene << '\n';
    if (!script.backend.empty()) out << "backend " << script.backend << '\n';
    if (!script.proxy.empty()) out << "proxy " << script.proxy << '\n';
    if (script.seed) out << "seed " << *script.seed << '\n';
    for (const InputEvent& event : script.events) {
        out << event.time << ' ' << word_of(event.kind) << ' ';
        if (event.kind == InputKind::command) {
            out << event.text << '\n';
        } else {
            out << shortest(event.position.x) << ' ' << shortest(event.position.y) << '\n';
        }
    }
}

void write_script(const std::filesystem::path& path, const Script& script)
{
    std::ostringstream text;
    write_script(text, script);
    core::io::OutputFile file(path);
    file.write(text.str());
    file.finish();
    file.commit();
}

}  // namespace kerf::sim
