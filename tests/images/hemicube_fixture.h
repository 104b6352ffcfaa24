// The fixture of tests of hemi-cubes: rows of patches, form factors between grids.
#pragma once

#include "gpu_fixture.h"
#include "patch_grids.h"

#include "render/radiosity/hemicube.h"

namespace lightbench {

using gpu_layout::kHemicubeOne;

class Hemicube : public gpu::GpuTest {
  protected:
    // Rows of these patches, by patch, then element.
    std::vector<std::vector<std::uint32_t>> rows_of(Hemicubes& cubes, const PatchMesh& mesh, const HemicubeRequest& request,
                                                    const std::vector<std::uint32_t>& patches) {
        gpu::Buffer rows = cubes.make_rows();
        gpu::Buffer chosen = gpu::make_buffer(device(), "chosen", request.batch * 4, vk::BufferUsageFlagBits::eStorageBuffer);
        gpu::Recorder recorder(device());
        std::vector<std::vector<std::uint32_t>> result;
        for (std::size_t first = 0; first < patches.size(); first += request.batch) {
            std::vector<std::uint32_t> some(request.batch, kNoElement);
            const std::size_t count = std::min<std::size_t>(request.batch, patches.size() - first);
            std::copy_n(patches.begin() + static_cast<std::ptrdiff_t>(first), count, some.begin());
            gpu::upload(device(), chosen, std::as_bytes(std::span(some)));
            cubes.record(recorder, chosen, rows);
            recorder.submit_and_wait();
            cubes.check();
            const auto words = gpu::download_all<std::uint32_t>(device(), rows);
            for (std::size_t i = 0; i < request.batch; ++i) {
                const auto row = words.begin() + static_cast<std::ptrdiff_t>(i * mesh.elements.size());
                if (i < count)
                    result.emplace_back(row, row + static_cast<std::ptrdiff_t>(mesh.elements.size()));
                else
                    EXPECT_EQ(std::count(row, row + static_cast<std::ptrdiff_t>(mesh.elements.size()), 0u), std::ssize(mesh.elements));
            }
        }
        return result;
    }
    std::vector<std::vector<std::uint32_t>> rows_of(const PatchMesh& mesh, const HemicubeRequest& request,
                                                    const std::vector<std::uint32_t>& patches) {
        Hemicubes cubes(device(), mesh, request);
        return rows_of(cubes, mesh, request, patches);
    }

    // From all patches of one grid to all elements of another, by area.
    double between(const PatchMesh& mesh, const AddedGrid& from, const AddedGrid& to, const HemicubeRequest& request) {
        std::vector<std::uint32_t> patches(from.patches);
        std::iota(patches.begin(), patches.end(), from.first_patch);
        const auto rows = rows_of(mesh, request, patches);
        double sum = 0, area = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double weight = mesh.patches[from.first_patch + i].area;
            area += weight;
            for (std::uint32_t e = 0; e < to.elements; ++e) sum += weight * rows[i][to.first_element + e];
        }
        return sum / area / kHemicubeOne;
    }
};

inline std::vector<std::uint32_t> all_patches(const PatchMesh& mesh) {
    std::vector<std::uint32_t> patches(mesh.patches.size());
    std::iota(patches.begin(), patches.end(), 0u);
    return patches;
}

} // namespace lightbench
