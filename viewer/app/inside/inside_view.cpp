#include "viewer/app/inside/inside_view.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "common/support/cpu_stopwatch.h"

namespace kerf::app {

namespace {

/// Half of the model's diagonal on the stage, metres.
constexpr double kRadius = 3.7;
/// The model is seen a little from above, radians.
constexpr double kTilt = 0.28;
/// Lines lie so much nearer to the eye than the surface that they run on.
constexpr float kLift = 0.004f;

constexpr glm::vec4 kOutlineColour{1.0f, 0.83f, 0.32f, 1.0f};
constexpr glm::vec4 kContourColour{0.16f, 0.75f, 1.0f, 0.7f};

glm::dmat4 placed(const inside::MovingPlane& plane)
{
    const glm::dmat4 tilted = glm::rotate(glm::dmat4(1.0), kTilt, glm::dvec3(1.0, 0.0, 0.0));
    return glm::translate(glm::scale(tilted, glm::dvec3(kRadius / plane.half_diagonal())), -plane.middle());
}

/// The plane's normal in the world.
glm::dvec3 world_normal(const inside::MovingPlane& plane)
{
    return glm::normalize(glm::dvec3(placed(plane) * glm::dvec4(plane.normal(), 0.0)));
}

/// In the world: what lies behind the plane has a product with it that is 0 or more.
glm::vec4 clip_of(const inside::MovingPlane& plane)
{
    const glm::dvec3 n = world_normal(plane);
    const glm::dvec3 on_plane(placed(plane) *
                              glm::dvec4(plane.middle() + plane.place() * plane.half_diagonal() * plane.normal(), 1.0));
    return {glm::vec3(-n), static_cast<float>(glm::dot(n, on_plane))};
}

void append_lines(const Section& section, const glm::mat4& model, const glm::vec3& eye, std::vector<glm::vec3>& lines)
{
    const auto world = [&](const Vec3f& p) {
        const glm::vec3 place(model * glm::vec4(p.x, p.y, p.z, 1.0f));
        return place + kLift * (eye - place);
    };
    for (std::size_t i = 0; i < section.path_count(); ++i) {
        const SectionPath path = section.path(i);
        for (std::size_t e = 0; e < path.edges.size(); ++e) {
            lines.push_back(world(path.points[e]));
            lines.push_back(world(path.points[(e + 1) % path.points.size()]));
        }
    }
}

}  // namespace

InsideView::InsideView(int width, int height) : store_(looks_), renderer_(looks_), target_(width, height), cap_(looks_)
{
}

void InsideView::resize(int width, int height)
{
    if (std::max(width, 1) == target_.width() && std::max(height, 1) == target_.height()) return;
    target_ = render::FrameTarget(width, height);
}

void InsideView::forget()
{
    model_.reset();
    store_.release_unused();
}

void InsideView::sync(inside::Study& study, std::span<const std::string> images, bool has_moved)
{
    if (!model_) model_ = store_.add(study.object(), images);
    if (!has_moved) return;
    core::CpuStopwatch watch;
    cap_.set(study.object(), study.section());
    upload_cpu_ms_ = 1e3 * watch.lap();
    list_lines(study);
}

void InsideView::list_lines(const inside::Study& study)
{
    const glm::mat4 model(placed(study.plane()));
    const glm::vec3 eye(sim::Camera::eye());
    outline_.clear();
    contours_.clear();
    append_lines(study.section(), model, eye, outline_);
    for (const Section& section : study.contours()) append_lines(section, model, eye, contours_);
}

void InsideView::paint(const inside::Study& study, bool is_closed, const ViewSettings& settings)
{
    const sim::Camera camera(double(target_.width()) / double(target_.height()));
    const render::Viewpoint viewpoint{glm::mat4(camera.view()), glm::mat4(camera.projection()),
                                      glm::vec3(sim::Camera::eye())};
    const glm::mat4 model(placed(study.plane()));
    const auto pattern_scale = static_cast<float>(0.5 / study.plane().half_diagonal());
    std::vector<render::DrawnObject> objects;
    objects.push_back({1, &*model_, model, pattern_scale, is_closed, true});
    if (cap_.drawn() != nullptr) objects.push_back({2, cap_.drawn(), model, pattern_scale, false, false, false});
    render::DrawOptions options;
    options.lighting = settings.lighting;
    options.wireframe = settings.wireframe;
    options.clip = clip_of(study.plane());
    target_.bind();
    renderer_.draw(viewpoint, objects, options, {0, 0, target_.width(), target_.height()});
    overlay_.draw_lines(contours_, kContourColour);
    overlay_.draw_lines(outline_, kOutlineColour);
    target_.resolve();
}

double InsideView::way_of(const inside::MovingPlane& plane, const glm::dvec2& from, const glm::dvec2& to)
{
    // Where the normal points to on the stage; towards the eye it is upwards that counts.
    glm::dvec2 along(world_normal(plane));
    const double length = glm::length(along);
    constexpr double kSeenFromTheSide = 0.2;
    along = length > kSeenFromTheSide ? along / length : glm::dvec2(0.0, 1.0);
    return glm::dot(to - from, along) / kRadius;
}

}  // namespace kerf::app
