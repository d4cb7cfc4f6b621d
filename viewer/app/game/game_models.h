#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "viewer/app/game/round.h"
#include "viewer/sim/model_library.h"
#include "viewer/sim/model_preparer.h"

namespace kerf::app {

/// What the menu and the games throw, and the thread that makes it ready ahead.
class GameModels
{
public:
    /// Reads the fruit. @throws core::io::FileError
    explicit GameModels(const std::filesystem::path& data_folder);

    const std::shared_ptr<sim::ModelLibrary>& library() const { return library_; }
    /// How many models the menu and the games show: the first ones of the library.
    std::size_t fruit() const { return fruit_; }
    /// Makes ready what a round throws next. @param waits  until it is
    void look_ahead(const Round& round, bool waits);

private:
    std::shared_ptr<sim::ModelLibrary> library_ = std::make_shared<sim::ModelLibrary>();
    sim::ModelPreparer preparer_{library_};
    std::size_t fruit_ = 0;
};

}  // namespace kerf::app
