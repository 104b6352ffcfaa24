// Quadrilaterals as grids of quadrilaterals. What cut.h says.
#include "radiosity/cut.h"

#include "scene/triangulate.h"

#include <algorithm>
#include <numeric>

namespace lightbench {
namespace {

// A strip much narrower than an element is not cut into squares of its width: its pieces get no shorter than this part of an element.
constexpr double kFinest = 1.0 / 16;

class GridCutter {
  public:
    GridCutter(const BaseMesh& base, const BaseEdges& edges, const CutSizes& sizes, std::vector<bool>& grid, Cutting& cutting)
        : base_(base), edges_(edges), sizes_(sizes), grid_(grid), cutting_(cutting), row_(edges.count()), pieces_(edges.count(), 1),
          first_inside_(edges.count(), kNone) {}
    void run();

  private:
    // A face's two directions: along its first edge, and along its second.
    struct Directions {
        std::uint32_t row[2];
        double length[2]; // mean of the two edges
    };
    double length(std::uint32_t edge) const {
        return glm::distance(base_.points[edges_.ends[edge][0]], base_.points[edges_.ends[edge][1]]);
    }
    std::uint32_t edge(const BaseFace& face, std::uint32_t side) const { return edges_.of_corner[face.first + side]; }
    Directions directions(const BaseFace& face);
    double wanted(const Directions& d, int along) const;
    void find_rows();
    void count_pieces();
    bool make_squarer();
    void leave_to_triangles();
    std::uint32_t on_edge(std::uint32_t edge, std::uint32_t from, std::uint32_t step, std::uint32_t pieces);
    void cut_face(std::uint32_t f);
    void place_points(const BaseFace& face, std::uint32_t nu, std::uint32_t nv);

    const BaseMesh& base_;
    const BaseEdges& edges_;
    const CutSizes& sizes_;
    std::vector<bool>& grid_;
    Cutting& cutting_;
    std::vector<std::uint32_t> row_;          // union-find over edges: those that get the same number of pieces
    std::vector<double> pieces_;              // of a row, at its root
    std::vector<std::uint32_t> first_inside_; // of an edge: the first of the points that cut it
    std::vector<std::uint32_t> lattice_;      // points of the face in work
};

GridCutter::Directions GridCutter::directions(const BaseFace& face) {
    Directions d{};
    for (std::uint32_t along = 0; along < 2; ++along) {
        d.row[along] = root_of(row_, edge(face, along));
        d.length[along] = 0.5 * (length(edge(face, along)) + length(edge(face, along + 2)));
    }
    return d;
}

void GridCutter::find_rows() {
    std::iota(row_.begin(), row_.end(), 0u);
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f) {
        if (!grid_[f]) continue;
        for (std::uint32_t side = 0; side < 2; ++side) {
            const std::uint32_t a = root_of(row_, edge(base_.faces[f], side)), b = root_of(row_, edge(base_.faces[f], side + 2));
            row_[std::max(a, b)] = std::min(a, b);
        }
    }
}

// A row gets what its longest edge needs.
void GridCutter::count_pieces() {
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f)
        for (std::uint32_t side = 0; grid_[f] && side < 4; ++side) {
            const std::uint32_t e = edge(base_.faces[f], side);
            double& pieces = pieces_[root_of(row_, e)];
            pieces = std::max(pieces, pieces_of(length(e), sizes_.element));
        }
}

// So many that no cell is more than twice as long as it is wide.
double GridCutter::wanted(const Directions& d, int along) const {
    const double width = d.length[1 - along] / pieces_[d.row[1 - along]];
    return pieces_of(d.length[along], std::max(2 * width, kFinest * sizes_.element));
}

// More pieces in a row make narrower cells of its other faces, which may need more in turn: until nothing changes. It ends, for no row gets
// more pieces than kFinest allows.
bool GridCutter::make_squarer() {
    bool changed = false;
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f) {
        if (!grid_[f]) continue;
        const Directions d = directions(base_.faces[f]);
        for (int along = 0; along < 2; ++along)
            if (const double n = wanted(d, along); n > pieces_[d.row[along]]) pieces_[d.row[along]] = n, changed = true;
    }
    return changed;
}

// Triangles cut no edge that is short enough. A grid that cuts an edge which it shares with one is given up, and all that hangs together
// with it.
void GridCutter::leave_to_triangles() {
    std::vector<std::uint32_t> part(base_.faces.size());
    std::iota(part.begin(), part.end(), 0u);
    std::vector<bool> given_up(base_.faces.size());
    const auto face_of = [&](std::uint32_t corner) { return edges_.face_of_corner[corner]; };
    const auto each_grid_pair = [&](auto visit) {
        for (std::uint32_t e = 0; e < edges_.count(); ++e) {
            const auto users = edges_.users_of(e);
            const auto first = std::find_if(users.begin(), users.end(), [&](std::uint32_t c) { return grid_[face_of(c)]; });
            if (first != users.end()) visit(e, face_of(*first), users);
        }
    };
    each_grid_pair([&](std::uint32_t, std::uint32_t f, std::span<const std::uint32_t> users) {
        for (std::uint32_t c : users)
            if (grid_[face_of(c)]) part[root_of(part, face_of(c))] = root_of(part, f);
    });
    each_grid_pair([&](std::uint32_t e, std::uint32_t f, std::span<const std::uint32_t> users) {
        if (pieces_[root_of(row_, e)] == 1) return;
        for (std::uint32_t c : users)
            if (!grid_[face_of(c)]) given_up[root_of(part, f)] = true;
    });
    for (std::uint32_t f = 0; f < grid_.size(); ++f)
        if (given_up[root_of(part, f)]) grid_[f] = false;
}

// The point `step` of `pieces` along an edge, counted from its end `from`; made from the edge's lower end, whoever asks.
std::uint32_t GridCutter::on_edge(std::uint32_t edge, std::uint32_t from, std::uint32_t step, std::uint32_t pieces) {
    const auto [low, high] = edges_.ends[edge];
    if (from != low) step = pieces - step;
    if (step == 0) return low;
    if (step == pieces) return high;
    if (first_inside_[edge] == kNone) {
        first_inside_[edge] = static_cast<std::uint32_t>(cutting_.points.size());
        const glm::dvec3 a = base_.points[low], b = base_.points[high];
        for (std::uint32_t i = 1; i < pieces; ++i) cutting_.points.push_back(a + (b - a) * (double(i) / pieces));
    }
    return first_inside_[edge] + step - 1;
}

void GridCutter::place_points(const BaseFace& face, std::uint32_t nu, std::uint32_t nv) {
    const auto loop = base_.loop(face);
    const auto corner = [&](std::size_t i) { return base_.points[loop[i].point]; };
    lattice_.clear();
    for (std::uint32_t j = 0; j <= nv; ++j)
        for (std::uint32_t i = 0; i <= nu; ++i) {
            if (j == 0 || j == nv) {
                lattice_.push_back(j == 0 ? on_edge(edge(face, 0), loop[0].point, i, nu) : on_edge(edge(face, 2), loop[3].point, i, nu));
            } else if (i == 0 || i == nu) {
                lattice_.push_back(i == 0 ? on_edge(edge(face, 3), loop[0].point, j, nv) : on_edge(edge(face, 1), loop[1].point, j, nv));
            } else {
                const double u = double(i) / nu, v = double(j) / nv;
                lattice_.push_back(static_cast<std::uint32_t>(cutting_.points.size()));
                cutting_.points.push_back((1 - v) * ((1 - u) * corner(0) + u * corner(1)) + v * ((1 - u) * corner(3) + u * corner(2)));
            }
        }
}

// Patches are blocks as even as they can be.
void GridCutter::cut_face(std::uint32_t f) {
    const Directions d = directions(base_.faces[f]);
    std::uint32_t n[2], blocks[2];
    for (int along = 0; along < 2; ++along) {
        n[along] = static_cast<std::uint32_t>(pieces_[d.row[along]]);
        blocks[along] = static_cast<std::uint32_t>(std::min(pieces_[d.row[along]], pieces_of(d.length[along], sizes_.patch)));
    }
    place_points(base_.faces[f], n[0], n[1]);
    const auto unit = static_cast<std::uint32_t>(cutting_.units.size());
    cutting_.units.resize(unit + std::size_t(blocks[0]) * blocks[1], Unit{f});
    for (std::uint32_t j = 0; j < n[1]; ++j)
        for (std::uint32_t i = 0; i < n[0]; ++i) {
            const std::uint32_t *low = &lattice_[std::size_t(j) * (n[0] + 1) + i], *high = low + n[0] + 1;
            const auto block = std::uint64_t(j) * blocks[1] / n[1] * blocks[0] + std::uint64_t(i) * blocks[0] / n[0];
            cutting_.pieces.push_back({{low[0], low[1], high[1], high[0]}, f, unit + static_cast<std::uint32_t>(block)});
        }
}

void GridCutter::run() {
    find_rows();
    count_pieces();
    while (make_squarer()) {
    }
    leave_to_triangles();
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f) {
        if (!grid_[f]) continue;
        const Directions d = directions(base_.faces[f]);
        count_sides(cutting_, (base_.faces[f].two_sided ? 2 : 1) * pieces_[d.row[0]] * pieces_[d.row[1]]);
    }
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f)
        if (grid_[f]) cut_face(f);
}

} // namespace

void cut_grids(const BaseMesh& base, const BaseEdges& edges, const CutSizes& sizes, std::vector<bool>& grid, Cutting& cutting) {
    GridCutter(base, edges, sizes, grid, cutting).run();
}

} // namespace lightbench
