#pragma once

#include <future>
#include <system_error>

namespace kerf::core::halfedge {

/// Does two jobs, the second one on another thread if that is wished for and there is one to be had, otherwise after the
/// first. Both have ended when it returns, or throws what a job has thrown.
///
/// (A future of one of the library's types would show that type's name to whoever loads a plugin with the library inside.)
template <class Here, class There>
void side_by_side(bool on_two_threads, Here here, There there)
{
    std::future<void> beside;
    if (on_two_threads) try {
            beside = std::async(std::launch::async, there);
        } catch (const std::system_error&) {
            // Then one after the other.
        }
    here();
    if (beside.valid())
        beside.get();
    else
        there();
}

}  // namespace kerf::core::halfedge
