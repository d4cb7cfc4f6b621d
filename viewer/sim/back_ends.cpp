#include "viewer/sim/back_ends.h"

#include "back_ends/back_ends.h"
#include "baseline/report_back_ends.h"

namespace kerf::sim {

const std::vector<std::string>& backend_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        add_report_back_ends();
        for (const RegisteredBackend* entry : back_ends()) all.push_back(entry->name);
        return all;
    }();
    return names;
}

std::string known_back_end(std::string_view name)
{
    add_report_back_ends();
    const RegisteredBackend* const entry = core::find_back_end(name);
    return entry == nullptr ? std::string() : entry->name;
}

std::unique_ptr<Backend> make_back_end(std::string_view name)
{
    add_report_back_ends();
    return core::make_back_end(name);
}

}  // namespace kerf::sim
