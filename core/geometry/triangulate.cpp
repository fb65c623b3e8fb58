#include "core/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reflectance {
namespace {

using Index = std::uint32_t;

struct Point {
    double x, y;
    friend bool operator==(const Point&, const Point&) = default;
};

/// Twice the signed area of abc: positive when they turn counter-clockwise.
double turn(const Point& a, const Point& b, const Point& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen along its normal, counter-clockwise, scaled to about one: tiny and huge polygons compute alike.
std::vector<Point> flattened(std::span<const Vec3d> polygon)
{
    double extent = 0.0;
    for (const Vec3d& p : polygon) {
        const Vec3d d = p - polygon[0];
        extent = std::max({extent, std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    }
    std::vector<Vec3d> local;
    local.reserve(polygon.size());
    for (const Vec3d& p : polygon)
        local.push_back(extent > 0.0 ? (p - polygon[0]) / extent : Vec3d());
    Vec3d normal;
    for (std::size_t i = 0; i < local.size(); ++i)
        normal += cross(local[i], local[(i + 1) % local.size()]);
    const Vec3d size{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
    std::vector<Point> points;
    points.reserve(local.size());
    for (const Vec3d& p : local) {
        if (size.z >= size.x && size.z >= size.y)
            points.push_back(normal.z >= 0.0 ? Point{p.x, p.y} : Point{p.y, p.x});
        else if (size.x >= size.y)
            points.push_back(normal.x >= 0.0 ? Point{p.y, p.z} : Point{p.z, p.y});
        else
            points.push_back(normal.y >= 0.0 ? Point{p.z, p.x} : Point{p.x, p.z});
    }
    return points;
}

/// Finds reflex corners inside a rectangle: only they can lie in an ear.
class ReflexGrid {
public:
    ReflexGrid(const std::vector<Point>& points, const std::vector<Index>& reflex)
    {
        for (const Point& p : points) {
            low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
            high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
        }
        side_ = std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(reflex.size()))), std::size_t{1},
                           std::size_t{1024});
        cellEnds_.assign(side_ * side_ + 1, 0);
        for (const Index i : reflex)
            ++cellEnds_[cellOf(points[i]) + 1];
        for (std::size_t c = 1; c < cellEnds_.size(); ++c)
            cellEnds_[c] += cellEnds_[c - 1];
        members_.resize(reflex.size());
        std::vector<Index> next(cellEnds_.begin(), cellEnds_.end() - 1);
        for (const Index i : reflex)
            members_[next[cellOf(points[i])]++] = i;
    }

    /// True when `test` holds for some corner in or near the rectangle; adds what it looked at to `cost`.
    template <class Test> bool any(const Point& low, const Point& high, std::size_t& cost, Test test) const
    {
        for (std::size_t row = place(low.y, low_.y, high_.y); row <= place(high.y, low_.y, high_.y); ++row)
            for (std::size_t column = place(low.x, low_.x, high_.x); column <= place(high.x, low_.x, high_.x); ++column) {
                const std::size_t cell = row * side_ + column;
                cost += 1 + cellEnds_[cell + 1] - cellEnds_[cell];
                for (Index m = cellEnds_[cell]; m < cellEnds_[cell + 1]; ++m)
                    if (test(members_[m]))
                        return true;
            }
        return false;
    }

private:
    std::size_t place(double value, double low, double high) const
    {
        if (!(high > low))
            return 0;
        const double cell = (value - low) / (high - low) * static_cast<double>(side_);
        return std::min(static_cast<std::size_t>(std::max(cell, 0.0)), side_ - 1);
    }
    std::size_t cellOf(const Point& p) const
    {
        return place(p.y, low_.y, high_.y) * side_ + place(p.x, low_.x, high_.x);
    }

    Point low_{1e300, 1e300};
    Point high_{-1e300, -1e300};
    std::size_t side_ = 1;
    std::vector<Index> cellEnds_;
    std::vector<Index> members_;
};

class EarClipper {
public:
    explicit EarClipper(std::span<const Vec3d> polygon)
        : points_(flattened(polygon)), count_(static_cast<Index>(points_.size())), before_(count_), after_(count_),
          isReflex_(count_, false), grid_(points_, linked())
    {
    }

    std::vector<std::array<Index, 3>> clip()
    {
        std::vector<std::array<Index, 3>> triangles;
        triangles.reserve(count_ - 2);
        Index corner = 0;
        Index refused = 0;
        Strictness strictness = Strictness::Touching;
        for (Index left = count_; left > 3;) {
            if (cost_ > budget || isEar(corner, strictness)) {
                triangles.push_back({before_[corner], corner, after_[corner]});
                // Going on two corners further spreads the cuts: fewer slivers than nibbling at one place.
                corner = remove(corner);
                --left;
                refused = 0;
                strictness = Strictness::Touching;
                continue;
            }
            corner = after_[corner];
            if (++refused >= left) {
                refused = 0;
                strictness = static_cast<Strictness>(static_cast<int>(strictness) + 1);
            }
        }
        triangles.push_back({before_[corner], corner, after_[corner]});
        return triangles;
    }

private:
    /// What forbids an ear; each round without one forbids less, so that crossing polygons come to an end too.
    enum class Strictness { Touching, Inside, Anything };

    /// Looked-at corners after which the rest is fanned: about a second.
    static constexpr std::size_t budget = 200'000'000;

    /// Ties the ring and returns the reflex corners.
    std::vector<Index> linked()
    {
        std::vector<Index> reflex;
        for (Index i = 0; i < count_; ++i) {
            before_[i] = i == 0 ? count_ - 1 : i - 1;
            after_[i] = i + 1 == count_ ? 0 : i + 1;
        }
        for (Index i = 0; i < count_; ++i)
            if (turn(points_[before_[i]], points_[i], points_[after_[i]]) <= 0.0) {
                isReflex_[i] = true;
                reflex.push_back(i);
            }
        return reflex;
    }

    bool isEar(Index corner, Strictness strictness)
    {
        if (strictness == Strictness::Anything)
            return true;
        const Point& a = points_[before_[corner]];
        const Point& b = points_[corner];
        const Point& c = points_[after_[corner]];
        if (!(turn(a, b, c) > 0.0))
            return false;
        const Point low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
        const Point high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
        return !grid_.any(low, high, cost_, [&](Index i) {
            const Point& p = points_[i];
            // A corner at the place of one of the ear's own belongs to a bridge edge: the same place, visited twice.
            if (!isReflex_[i] || p == a || p == b || p == c)
                return false;
            const double ab = turn(a, b, p);
            const double bc = turn(b, c, p);
            const double ca = turn(c, a, p);
            if (strictness == Strictness::Touching)
                return ab >= 0.0 && bc >= 0.0 && ca >= 0.0;
            return ab > 0.0 && bc > 0.0 && ca > 0.0;
        });
    }

    /// Takes the corner out and returns the one to look at next.
    Index remove(Index corner)
    {
        const Index previous = before_[corner];
        const Index next = after_[corner];
        after_[previous] = next;
        before_[next] = previous;
        isReflex_[corner] = false;
        for (const Index i : {previous, next})
            isReflex_[i] = isReflex_[i] && turn(points_[before_[i]], points_[i], points_[after_[i]]) <= 0.0;
        return after_[next];
    }

    std::vector<Point> points_;
    Index count_;
    std::vector<Index> before_, after_;
    std::vector<bool> isReflex_;
    ReflexGrid grid_;
    std::size_t cost_ = 0;
};

/// The shorter diagonal of a convex quad; of a concave one the only diagonal that lies inside.
std::vector<std::array<Index, 3>> quad(std::span<const Vec3d> q)
{
    const Vec3d normal = cross(normalized(q[2] - q[0]), normalized(q[3] - q[1]));
    const auto faces = [&](Index a, Index b, Index c) {
        return dot(cross(normalized(q[b] - q[a]), normalized(q[c] - q[b])), normal) > 0.0;
    };
    const bool firstInside = faces(0, 1, 2) && faces(0, 2, 3);
    const bool secondInside = faces(0, 1, 3) && faces(1, 2, 3);
    const bool firstIsShorter = length(q[2] - q[0]) <= length(q[3] - q[1]) * (1.0 + 1e-9);
    if (secondInside && (!firstInside || !firstIsShorter))
        return {{0, 1, 3}, {1, 2, 3}};
    return {{0, 1, 2}, {0, 2, 3}};
}

} // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Vec3d> polygon)
{
    if (polygon.size() < 3)
        return {};
    if (polygon.size() == 3)
        return {{0, 1, 2}};
    if (polygon.size() == 4)
        return quad(polygon);
    return EarClipper(polygon).clip();
}

} // namespace reflectance
