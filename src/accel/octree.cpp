// Octree of voxels (S23; shaders/shared/rays.h: kOctreeHeaderTexels). In: RayPrimitives, objects a voxel may hold. Out: AccelTables::nodes.
// Glassner 1984, "Space Subdivision for Fast Ray Tracing". Built level by level, so that a limit on memory cuts all branches alike.
#include "accel/parallel.h"
#include "accel/voxels.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

constexpr std::uint32_t kObjects = 4; // that a voxel may hold where nobody asks
// References at which no deeper level is begun; that one may hold four times as many.
constexpr std::size_t kReferencesEach = 16, kReferencesAtLeast = std::size_t{1} << 20;

struct Open {
    std::array<std::uint32_t, 3> at{};
    std::uint32_t first = 0, count = 0; // of `numbers` of its level
    std::size_t parent = 0;             // word that waits for its name
};

struct Level {
    std::vector<Open> open;
    std::vector<std::uint32_t> numbers;
};

// What comes of some successive cells of a level, found by one thread: the children of those that are split, eight each.
struct Piece {
    std::size_t first = 0, last = 0; // cells
    std::vector<bool> split{};       // of each
    Level below{};                   // Open::first counts from the piece's own numbers
};
constexpr std::size_t kPiece = 4096; // primitives of a piece's cells, repeats counted, at least

class Octree {
  public:
    Octree(const RayPrimitives& primitives, const AccelRequest& request);
    void build();
    void write(AccelTables& tables) const;

  private:
    Voxel voxel(const std::array<std::uint32_t, 3>& at, std::uint32_t side) const;
    bool split(const Level& level, const Open& cell, std::uint32_t side, Level& below) const;
    std::vector<Piece> pieces_of(const Level& level) const;
    void split(const Level& level, std::uint32_t side, Piece& piece) const;
    Level merge(const Level& level, const std::vector<Piece>& pieces);
    void close(const Level& level, const Open& cell);
    static std::array<std::uint32_t, 3> corner(const Open& cell, std::uint32_t child, std::uint32_t side);

    VoxelItems items_;
    glm::vec3 origin_{0}, step_{1};
    std::uint32_t objects_, most_depth_, depth_ = 0;
    unsigned threads_;
    std::vector<std::uint32_t> words_{kNothing}; // the root's name, then 8 a node
    std::vector<std::uint32_t> leaves_, references_;
};

Octree::Octree(const RayPrimitives& primitives, const AccelRequest& request)
    : items_(primitives), objects_(request.leaf > 0 ? request.leaf : kObjects),
      most_depth_(request.depth > 0 ? std::min(request.depth, kOctreeDepth) : kOctreeDepth), threads_(request.threads) {
    for (int i = 0; i < 3; ++i) {
        const Voxel& all = items_.all();
        origin_[i] = std::nextafter(static_cast<float>(all.min[i]), -INFINITY);
        const double extent = std::max(all.max[i] - origin_[i], 0x1p-100);
        step_[i] = std::nextafter(static_cast<float>(extent / kOctreeSide), INFINITY);
    }
}

Voxel Octree::voxel(const std::array<std::uint32_t, 3>& at, std::uint32_t side) const {
    Voxel voxel;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t k = at[static_cast<std::size_t>(i)];
        voxel.min[i] = double{origin_[i]} + double{step_[i]} * k;
        voxel.max[i] = double{origin_[i]} + double{step_[i]} * (k + side);
    }
    return voxel;
}

std::array<std::uint32_t, 3> Octree::corner(const Open& cell, std::uint32_t child, std::uint32_t side) {
    auto at = cell.at;
    for (std::uint32_t i = 0; i < 3; ++i) at[i] += (child >> i & 1) * side;
    return at;
}

void Octree::close(const Level& level, const Open& cell) {
    if (cell.count == 0) return; // its word says kNothing
    words_[cell.parent] = kRefLeaf | static_cast<std::uint32_t>(leaves_.size() / 2);
    leaves_.push_back(static_cast<std::uint32_t>(references_.size()));
    leaves_.push_back(cell.count);
    for (std::uint32_t i = 0; i < cell.count; ++i) references_.push_back(items_.reference(level.numbers[cell.first + i]));
}

// Not if no child would hold fewer objects (TS-9), nor if the children together hold four times as many: a ray that meets a voxel meets two of
// its eight children on average, each a quarter of its surface, so that nothing is gained.
bool Octree::split(const Level& level, const Open& cell, std::uint32_t side, Level& below) const {
    const std::size_t first_open = below.open.size(), first_number = below.numbers.size();
    bool fewer = false;
    for (std::uint32_t c = 0; c < 8; ++c) {
        Open child{corner(cell, c, side / 2), static_cast<std::uint32_t>(below.numbers.size()), 0, 0};
        const Voxel box = voxel(child.at, side / 2);
        for (std::uint32_t i = 0; i < cell.count; ++i)
            if (items_.overlaps(level.numbers[cell.first + i], box)) below.numbers.push_back(level.numbers[cell.first + i]);
        child.count = static_cast<std::uint32_t>(below.numbers.size()) - child.first;
        fewer = fewer || child.count < cell.count;
        below.open.push_back(child);
    }
    if (fewer && below.numbers.size() - first_number < 4 * std::size_t{cell.count}) return true;
    below.open.resize(first_open);
    below.numbers.resize(first_number);
    return false;
}

std::vector<Piece> Octree::pieces_of(const Level& level) const {
    std::vector<Piece> pieces;
    std::size_t primitives = kPiece;
    for (std::size_t i = 0; i < level.open.size(); ++i) {
        if (primitives >= kPiece) pieces.push_back({.first = i}), primitives = 0;
        pieces.back().last = i + 1;
        primitives += level.open[i].count;
    }
    return pieces;
}

void Octree::split(const Level& level, std::uint32_t side, Piece& piece) const {
    for (std::size_t i = piece.first; i < piece.last; ++i)
        piece.split.push_back(level.open[i].count > objects_ && split(level, level.open[i], side, piece.below));
}

// Names the nodes and leaves in the order of the cells. Returns the level below.
Level Octree::merge(const Level& level, const std::vector<Piece>& pieces) {
    Level below;
    for (const Piece& piece : pieces) {
        const auto offset = static_cast<std::uint32_t>(below.numbers.size());
        std::size_t child = 0;
        for (std::size_t i = piece.first; i < piece.last; ++i) {
            if (piece.split.empty() || !piece.split[i - piece.first]) {
                close(level, level.open[i]);
                continue;
            }
            words_[level.open[i].parent] = static_cast<std::uint32_t>((words_.size() - 1) / 8);
            for (std::size_t c = 0; c < 8; ++c) {
                Open open = piece.below.open[child++];
                open.first += offset;
                open.parent = words_.size() + c;
                below.open.push_back(open);
            }
            words_.resize(words_.size() + 8, kNothing);
        }
        below.numbers.insert(below.numbers.end(), piece.below.numbers.begin(), piece.below.numbers.end());
    }
    return below;
}

// A walk that stands in an empty leaf reads the first one all the same: there is always one, if only of no references.
void Octree::build() {
    const std::size_t most = std::max(kReferencesEach * items_.size(), kReferencesAtLeast);
    Level level;
    for (std::size_t n = 0; n < items_.size(); ++n) level.numbers.push_back(static_cast<std::uint32_t>(n));
    level.open.push_back({{}, 0, static_cast<std::uint32_t>(items_.size()), 0});
    for (std::uint32_t side = kOctreeSide, depth = 0; !level.open.empty(); side /= 2, ++depth) {
        depth_ = depth;
        auto pieces = pieces_of(level);
        const bool room = references_.size() + level.numbers.size() < most && depth < most_depth_;
        if (room) run_parallel(pieces.size(), threads_, [&](std::size_t i) { split(level, side, pieces[i]); });
        level = merge(level, pieces);
    }
    if (leaves_.empty()) leaves_.assign(2, 0);
}

void Octree::write(AccelTables& tables) const {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    const std::size_t splits = (words_.size() - 1) / 8, leaves = kOctreeHeaderTexels + kOctreeNodeTexels * splits;
    const std::size_t references = leaves + (leaves_.size() / 2 + 1) / 2;
    tables.nodes = {{bits(origin_.x), bits(origin_.y), bits(origin_.z), words_[0]},
                    {bits(step_.x), bits(step_.y), bits(step_.z), static_cast<std::uint32_t>(leaves)},
                    {static_cast<std::uint32_t>(references), 0, 0, 0}};
    append_words(tables.nodes, {words_.begin() + 1, words_.end()});
    append_words(tables.nodes, leaves_);
    append_words(tables.nodes, references_);
    tables.stack = std::max(depth_ + 1, 3u); // a walk that is put down leaves three words there
    tables.depth = depth_;
    tables.node_count = 1 + 8 * splits;
    tables.reference_count = references_.size();
}

} // namespace

void build_octree(AccelTables& tables, const RayPrimitives& primitives, const AccelRequest& request) {
    Octree octree(primitives, request);
    octree.build();
    octree.write(tables);
}

} // namespace lightbench
