#include "viewer/inside/study.h"

#include <utility>

#include "common/support/cpu_stopwatch.h"

namespace kerf::inside {

namespace {

/// Contours over the whole diagonal of a model.
constexpr int kContours = 40;

}  // namespace

Study::Study(std::string name, Object object)
    : name_(std::move(name)), object_(std::move(object)), plane_(object_.bounds())
{
}

void Study::show_contours(bool on)
{
    shows_contours_ = on;
    asked_.reset();
}

bool Study::update()
{
    const Plane plane = plane_.plane();
    if (asked_ == plane) return false;
    asked_ = plane;
    core::CpuStopwatch watch;
    SectionOptions options;
    options.fill = true;
    static_cast<void>(kerf::section(object_, plane, section_, options));
    cost_.cpu_ms = 1e3 * watch.lap();
    ask_for_contours(plane);
    cost_.contours_cpu_ms = 1e3 * watch.lap();
    return true;
}

void Study::ask_for_contours(const Plane& plane)
{
    heights_.clear();
    const double step = 2.0 * plane_.half_diagonal() / kContours;
    const double lowest = plane.offset() - (1.0 + plane_.place()) * plane_.half_diagonal();
    for (int i = 1; shows_contours_ && i <= kContours; ++i)
        if (const double height = plane.offset() - i * step; height > lowest) heights_.push_back(height);
    StackOptions options;
    options.section.nesting = false;
    static_cast<void>(kerf::sections(object_, plane.normal(), heights_, contours_, options));
}

}  // namespace kerf::inside
