// What the header of the same name says.
#include "images/radiosity_rooms.h"

#include "shared/radiosity.h"

#include <algorithm>
#include <cmath>

namespace lightbench {

using gpu_layout::kHemicubeOne;

Room make_room(const std::vector<double>& areas, std::size_t of_patch) {
    Room room;
    room.areas = areas;
    room.mesh.elements.resize(areas.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (i % of_patch == 0) room.mesh.patches.push_back({.first = static_cast<std::uint32_t>(i)});
        Patch& patch = room.mesh.patches.back();
        patch.count += 1, patch.area += areas[i];
        room.mesh.elements[i].area = areas[i];
        room.mesh.elements[i].patch = static_cast<std::uint32_t>(room.mesh.patches.size() - 1);
    }
    room.emission.resize(areas.size(), glm::vec3(0));
    room.reflectance.resize(areas.size(), glm::vec3(0));
    return room;
}

std::vector<std::uint32_t> to_units(const std::vector<double>& row, double sum) {
    std::vector<std::uint32_t> units;
    std::int64_t left = std::llround(sum * kHemicubeOne);
    for (const double f : row) {
        units.push_back(static_cast<std::uint32_t>(std::llround(f * kHemicubeOne)));
        left -= units.back();
    }
    auto& largest = *std::ranges::max_element(units);
    largest = static_cast<std::uint32_t>(largest + left);
    return units;
}

std::vector<glm::dvec3> Room::direct_solution() const {
    FormMatrix all = make_form_matrix(size());
    for (std::size_t i = 0; i < size(); ++i)
        for (std::size_t j = 0; j < size(); ++j) all.at(i, j) = rows[mesh.elements[i].patch][j] / double{kHemicubeOne};
    for (std::size_t i = 0; i < size(); ++i) {
        const double sum = std::max(all.row_sum(i), 1.0);
        for (std::size_t j = 0; j < size(); ++j) all.at(i, j) /= sum;
    }
    const std::vector<glm::dvec3> e(emission.begin(), emission.end()), rho(reflectance.begin(), reflectance.end());
    return solve_directly(from_shots(all, areas), e, rho);
}

namespace {

// A patch's row is the mean of its elements', by area.
void take_rows(Room& room, const FormMatrix& m) {
    for (const Patch& patch : room.mesh.patches) {
        std::vector<double> row(m.size);
        for (std::size_t i = patch.first; i < patch.first + patch.count; ++i)
            for (std::size_t j = 0; j < m.size; ++j) row[j] += m.at(i, j) * room.areas[i] / patch.area;
        room.rows.push_back(to_units(row, 1));
    }
}

} // namespace

Room random_room(std::size_t elements, std::size_t of_patch, float most_reflectance, unsigned seed) {
    std::mt19937 engine(seed);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    std::vector<double> areas(elements);
    for (double& a : areas) a = static_cast<float>(number(0.05, 1));
    Room room = make_room(areas, of_patch);
    FormMatrix m = make_form_matrix(elements);
    for (std::size_t i = 0; i < elements; ++i)
        for (std::size_t j = i + 1; j < elements; ++j) m.at(i, j) = m.at(j, i) = number(0, 1) * areas[j];
    balance(m, areas, 1e-12, 10'000);
    take_rows(room, m);
    for (std::size_t i = 0; i < elements; ++i) {
        if (i % 7 == 0) room.emission[i] = {number(0, 5), number(0, 5), number(0, 5)};
        room.reflectance[i] = most_reflectance * glm::vec3(number(0, 1), number(0, 1), number(0, 1));
    }
    return room;
}

Room sphere_room(std::size_t elements, glm::vec3 emission, glm::vec3 reflectance) {
    Room room = make_room(std::vector<double>(elements, 0.5), 1);
    const std::vector<double> row(elements, 1.0 / static_cast<double>(elements));
    room.rows.assign(elements, to_units(row, 1));
    room.emission.assign(elements, emission), room.reflectance.assign(elements, reflectance);
    return room;
}

Room two_spheres(double inner_area, double outer_area) {
    Room room = make_room({inner_area, outer_area}, 1);
    room.rows = {to_units({0, 1}, 1), to_units({inner_area / outer_area, 1 - inner_area / outer_area}, 1)};
    return room;
}

unsigned shoot_batch(gpu::Device& device, ProgressiveSolver& solver, const Room& room, unsigned batch, unsigned most) {
    gpu::Recorder recorder(device);
    solver.record_choice(recorder, most);
    recorder.submit_and_wait();
    std::vector<std::uint32_t> rows;
    for (const std::uint32_t patch : gpu::download_all<std::uint32_t>(device, solver.chosen())) {
        const std::vector<std::uint32_t> none(room.size());
        const auto& row = patch == kNoElement ? none : room.rows.at(patch);
        rows.insert(rows.end(), row.begin(), row.end());
    }
    EXPECT_EQ(rows.size(), batch * room.size());
    rows.resize((rows.size() + 3) / 4 * 4, 77); // not to be read as anybody's
    gpu::Buffer table = gpu::make_texel_buffer(device, "rows", rows.size() * 4);
    gpu::upload(device, table, std::as_bytes(std::span(rows)));
    solver.record_shots(recorder, table);
    recorder.submit_and_wait();
    return solver.last_shots();
}

unsigned shoot_until(gpu::Device& device, ProgressiveSolver& solver, const Room& room, unsigned batch, double fraction, unsigned most) {
    unsigned shots = 0;
    for (unsigned i = 0; solver.ledger().unshot_fraction() >= fraction; ++i) {
        if (i == most) {
            ADD_FAILURE() << "unshot " << solver.ledger().unshot_fraction() << " after " << most << " batches";
            break;
        }
        shots += shoot_batch(device, solver, room, batch);
    }
    return shots;
}

gpu::Buffer full_matrix(gpu::Device& device, const Room& room) {
    std::vector<std::uint32_t> all;
    for (const auto& row : room.rows) all.insert(all.end(), row.begin(), row.end());
    all.resize((all.size() + 3) / 4 * 4);
    gpu::Buffer matrix = gpu::make_texel_buffer(device, "matrix", all.size() * 4);
    gpu::upload(device, matrix, std::as_bytes(std::span(all)));
    return matrix;
}

} // namespace lightbench
