#include "viewer/game/user_files.h"

namespace kerf::game {

UserFiles::UserFiles(const std::filesystem::path& folder) : folder_(folder), known_(folder)
{
    message_ = known_.take_message();
    if (!folder_.empty()) writer_ = std::thread([this] { write_all(); });
}

UserFiles::~UserFiles()
{
    if (!writer_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        deadline_ = std::chrono::steady_clock::now() + kPatience;
    }
    wakes_.notify_one();
    writer_.join();
}

std::optional<std::size_t> UserFiles::add(GameMode mode, const HighScore& score)
{
    const std::optional<std::size_t> place = known_.insert(mode, score);
    if (!place || folder_.empty()) return place;
    {
        const std::lock_guard lock(mutex_);
        scores_.emplace_back(mode, score);
    }
    wakes_.notify_one();
    return place;
}

void UserFiles::store(const StoredSettings& settings)
{
    if (folder_.empty()) return;
    {
        const std::lock_guard lock(mutex_);
        settings_ = settings;
    }
    wakes_.notify_one();
}

std::string UserFiles::take_message()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(message_, {});
}

bool UserFiles::gives_up()
{
    const std::lock_guard lock(mutex_);
    return deadline_ && std::chrono::steady_clock::now() > *deadline_;
}

void UserFiles::write_all()
{
    const GivesUp gives_up_now = [this] { return gives_up(); };
    std::unique_lock lock(mutex_);
    while (true) {
        wakes_.wait(lock, [this] { return !scores_.empty() || settings_ || deadline_; });
        std::string message;
        if (!scores_.empty()) {
            const auto [mode, score] = std::move(scores_.front());
            scores_.pop_front();
            lock.unlock();
            // Another program may have added to the file meanwhile.
            HighScores stored(folder_);
            stored.take_message();  // add() reads again and says it again
            stored.add(mode, score, gives_up_now);
            message = stored.take_message();
            lock.lock();
        } else if (settings_) {
            const StoredSettings settings = *std::exchange(settings_, std::nullopt);
            lock.unlock();
            message = save_settings(folder_, settings, gives_up_now);
            lock.lock();
        } else {
            return;
        }
        if (!message.empty()) message_ = std::move(message);
    }
}

}  // namespace kerf::game
