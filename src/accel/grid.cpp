// Uniform grid of voxels (S22; shaders/shared/rays.h: kGridHeaderTexels). In: RayPrimitives, cells asked for. Out: AccelTables::nodes.
// Cleary, Wyvill 1988, "Analysis of an algorithm for fast ray tracing using uniform space subdivision".
#include "accel/voxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace lightbench {
namespace {

using gpu_layout::uvec4;

constexpr double kDensity = 3; // cells a primitive where nobody asks
constexpr std::uint32_t kMostCells = 1024, kRefined = 4;
constexpr std::size_t kMostVoxels = std::size_t{1} << 26;
// References that the grid may hold before it is made coarser: a million primitives that each fill the scene must not fill the memory.
constexpr std::size_t kReferencesEach = 48, kReferencesAtLeast = std::size_t{1} << 20;

struct Grid {
    glm::vec3 origin{0}, step{1}; // as the shader has them
    std::array<std::uint32_t, 3> cells{1, 1, 1};

    std::size_t count() const { return std::size_t{cells[0]} * cells[1] * cells[2]; }
    double plane(int axis, std::uint32_t k) const { return double{origin[axis]} + double{step[axis]} * k; }
    Voxel voxel(const std::array<std::uint32_t, 3>& at) const {
        Voxel voxel;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t k = at[static_cast<std::size_t>(i)];
            voxel.min[i] = plane(i, k), voxel.max[i] = plane(i, k + 1);
        }
        return voxel;
    }
};

// Cells of equal sides, `density` of them a primitive. An axis without extent counts as one of 1/1000 of the largest.
std::array<std::uint32_t, 3> cells_of(const AccelRequest& request, std::size_t primitives, const glm::dvec3& extent) {
    auto cells = request.cells;
    const double largest = std::max({extent.x, extent.y, extent.z});
    const glm::dvec3 size = glm::max(extent, glm::dvec3(1e-3 * largest));
    const double wanted = (request.density > 0 ? request.density : kDensity) * static_cast<double>(std::max<std::size_t>(primitives, 1));
    const double side = std::cbrt(size.x / wanted * size.y * size.z);
    for (std::size_t i = 0; i < 3; ++i) {
        const double n = std::round(size[static_cast<int>(i)] / side);
        if (cells[i] == 0) cells[i] = n >= 1 ? static_cast<std::uint32_t>(std::min(n, double{kMostCells})) : 1;
        cells[i] = std::min(cells[i], kMostCells);
    }
    while (std::size_t{cells[0]} * cells[1] * cells[2] > kMostVoxels) *std::max_element(cells.begin(), cells.end()) /= 2;
    return cells;
}

Grid grid_of(const Voxel& all, const std::array<std::uint32_t, 3>& cells) {
    Grid grid{.cells = cells};
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t n = cells[static_cast<std::size_t>(i)];
        grid.origin[i] = std::nextafter(static_cast<float>(all.min[i]), -INFINITY);
        const double extent = std::max(all.max[i] - grid.origin[i], 0x1p-100);
        grid.step[i] = std::nextafter(static_cast<float>(extent / n), INFINITY);
    }
    return grid;
}

class Filler {
  public:
    Filler(const VoxelItems& items, const Grid& grid) : items_(items), grid_(grid) {}

    // Calls visit(cell) for every cell that the primitive may reach into.
    template <typename Visit> void cells(std::size_t number, const Visit& visit) const {
        std::array<std::uint32_t, 3> lo{}, hi{};
        std::size_t volume = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            std::tie(lo[i], hi[i]) = range(static_cast<int>(i), items_.box(number));
            volume *= hi[i] - lo[i] + 1;
        }
        for (std::uint32_t z = lo[2]; z <= hi[2]; ++z)
            for (std::uint32_t y = lo[1]; y <= hi[1]; ++y)
                for (std::uint32_t x = lo[0]; x <= hi[0]; ++x)
                    if (volume < kRefined || items_.overlaps(number, grid_.voxel({x, y, z})))
                        visit(x + grid_.cells[0] * (y + std::size_t{grid_.cells[1]} * z));
    }

  private:
    // Closed: a box that ends on a plane belongs to the cells on both sides. Division rounds: one cell more on each side, if it touches.
    std::pair<std::uint32_t, std::uint32_t> range(int axis, const Voxel& box) const {
        const auto last = grid_.cells[static_cast<std::size_t>(axis)] - 1;
        const auto cell = [&](double x) {
            const double k = std::floor((x - grid_.origin[axis]) / grid_.step[axis]);
            return k > 0 ? static_cast<std::uint32_t>(std::min(k, double(last))) : 0u;
        };
        std::uint32_t lo = cell(box.min[axis]), hi = cell(box.max[axis]);
        while (lo > 0 && grid_.plane(axis, lo) >= box.min[axis]) --lo;
        while (hi < last && grid_.plane(axis, hi + 1) <= box.max[axis]) ++hi;
        return {lo, hi};
    }

    const VoxelItems& items_;
    const Grid& grid_;
};

struct Lists {
    std::vector<std::uint32_t> starts, references; // of cell c: references[starts[c] .. starts[c + 1])
};

std::size_t count_references(Lists& lists, const VoxelItems& items, const Grid& grid, std::size_t most) {
    lists.starts.assign(grid.count() + 1, 0);
    const Filler filler(items, grid);
    std::size_t total = 0;
    for (std::size_t n = 0; n < items.size() && total <= most; ++n)
        filler.cells(n, [&](std::size_t cell) { ++lists.starts[cell], ++total; });
    return total;
}

// Counted backwards into place: the references of a cell lie by descending number, then starts[c] is where they begin.
void fill(Lists& lists, const VoxelItems& items, const Grid& grid, std::size_t total) {
    for (std::size_t c = 1; c < lists.starts.size(); ++c) lists.starts[c] += lists.starts[c - 1];
    lists.references.resize(total);
    const Filler filler(items, grid);
    for (std::size_t n = items.size(); n-- > 0;)
        filler.cells(n, [&](std::size_t cell) { lists.references[--lists.starts[cell]] = items.reference(n); });
}

void write(AccelTables& tables, const Grid& grid, const Lists& lists) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    const auto first = static_cast<std::uint32_t>(gpu_layout::kGridHeaderTexels + (grid.count() + 1) / 2);
    tables.nodes = {{bits(grid.origin.x), bits(grid.origin.y), bits(grid.origin.z), grid.cells[0]},
                    {bits(grid.step.x), bits(grid.step.y), bits(grid.step.z), grid.cells[1]},
                    {grid.cells[2], first, 0, 0}};
    std::vector<std::uint32_t> words;
    words.reserve(2 * grid.count());
    for (std::size_t c = 0; c < grid.count(); ++c) {
        words.push_back(lists.starts[c]);
        words.push_back(lists.starts[c + 1] - lists.starts[c]);
    }
    append_words(tables.nodes, words);
    append_words(tables.nodes, lists.references);
}

} // namespace

void build_grid(AccelTables& tables, const RayPrimitives& primitives, const AccelRequest& request) {
    const VoxelItems items(primitives);
    const std::size_t most = std::max(kReferencesEach * items.size(), kReferencesAtLeast);
    auto cells = cells_of(request, items.size(), items.all().max - items.all().min);
    Grid grid = grid_of(items.all(), cells);
    Lists lists;
    std::size_t total = count_references(lists, items, grid, most);
    while (total > most && grid.count() > 1) {
        for (auto& n : cells) n = (n + 1) / 2;
        grid = grid_of(items.all(), cells);
        total = count_references(lists, items, grid, most);
    }
    fill(lists, items, grid, total);
    write(tables, grid, lists);
    tables.stack = 1;
    tables.node_count = grid.count();
    tables.reference_count = total;
}

} // namespace lightbench
