#include "core/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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

/// Finds reflex corners inside a triangle: only they can make it no ear.
class ReflexGrid {
public:
    ReflexGrid(const std::vector<Point>& points, const std::vector<Index>& reflex)
    {
        for (const Point& p : points) {
            low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
            high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
        }
        // About one corner per cell, and cells about as wide as high.
        const double count = static_cast<double>(reflex.size() + 1);
        const double shape = std::clamp((high_.x - low_.x) / std::max(high_.y - low_.y, 1e-300), 1.0 / count, count);
        columns_ = std::max(std::size_t{1}, static_cast<std::size_t>(std::sqrt(count * shape)));
        rows_ = std::max(std::size_t{1}, static_cast<std::size_t>(std::sqrt(count / shape)));
        cellEnds_.assign(columns_ * rows_ + 1, 0);
        for (const Index i : reflex)
            ++cellEnds_[cellOf(points[i]) + 1];
        for (std::size_t c = 1; c < cellEnds_.size(); ++c)
            cellEnds_[c] += cellEnds_[c - 1];
        members_.resize(reflex.size());
        std::vector<Index> next(cellEnds_.begin(), cellEnds_.end() - 1);
        for (const Index i : reflex)
            members_[next[cellOf(points[i])]++] = i;
    }

    /// True when `test` holds for some corner in or near the triangle; adds what it looked at to `cost`.
    template <class Test> bool any(const std::array<Point, 3>& triangle, std::size_t& cost, Test test) const
    {
        const auto [lowest, highest] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        for (std::size_t row = rowOf(lowest); row <= rowOf(highest); ++row) {
            const auto [left, right] = extentIn(triangle, row);
            for (std::size_t cell = row * columns_ + columnOf(left); cell <= row * columns_ + columnOf(right); ++cell) {
                cost += 1 + cellEnds_[cell + 1] - cellEnds_[cell];
                for (Index m = cellEnds_[cell]; m < cellEnds_[cell + 1]; ++m)
                    if (test(members_[m]))
                        return true;
            }
        }
        return false;
    }

private:
    /// The least and the greatest x of the triangle within a row: a long thin one meets few cells.
    std::pair<double, double> extentIn(const std::array<Point, 3>& triangle, std::size_t row) const
    {
        // A little more than the row, so that rounding excludes no corner.
        const double height = (high_.y - low_.y) / static_cast<double>(rows_);
        const double bottom = low_.y + height * (static_cast<double>(row) - 1e-6);
        const double top = low_.y + height * (static_cast<double>(row) + 1.0 + 1e-6);
        double left = high_.x;
        double right = low_.x;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& a = triangle[k];
            const Point& b = triangle[(k + 1) % 3];
            for (const double y : {a.y, b.y, bottom, top}) {
                if (y < std::max(bottom, std::min(a.y, b.y)) || y > std::min(top, std::max(a.y, b.y)))
                    continue;
                const double x = a.y == b.y ? a.x : a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
                left = std::min({left, x, a.y == b.y ? b.x : x});
                right = std::max({right, x, a.y == b.y ? b.x : x});
            }
        }
        const double slack = 1e-9 * (high_.x - low_.x);
        return {left - slack, right + slack};
    }

    static std::size_t place(double value, double low, double high, std::size_t count)
    {
        if (!(high > low))
            return 0;
        const double cell = (value - low) / (high - low) * static_cast<double>(count);
        return std::min(static_cast<std::size_t>(std::max(cell, 0.0)), count - 1);
    }
    std::size_t columnOf(double x) const { return place(x, low_.x, high_.x, columns_); }
    std::size_t rowOf(double y) const { return place(y, low_.y, high_.y, rows_); }
    std::size_t cellOf(const Point& p) const { return rowOf(p.y) * columns_ + columnOf(p.x); }

    Point low_{1e300, 1e300};
    Point high_{-1e300, -1e300};
    std::size_t columns_ = 1, rows_ = 1;
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
                areEarsRare_ = areEarsRare_ || refused > 64;
                corner = remove(corner);
                --left;
                refused = 0;
                strictness = Strictness::Touching;
                continue;
            }
            corner = after_[corner];
            ++cost_;
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

    /// Looked-at corners after which the rest is fanned: a second or two. Simple polygons of 100 000 corners need less.
    static constexpr std::size_t budget = 30'000'000;

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
        reflexLeft_ = reflex.size();
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
        if (reflexLeft_ == 0) // convex from here on
            return true;
        return !grid_.any({a, b, c}, cost_, [&](Index i) {
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

    /// Takes the corner out and returns the one to look at next. Two corners further on spreads the cuts, which makes
    /// better triangles than nibbling at one place; but where ears are rare (a long band has one at each end) the next
    /// one is most likely here, and a walk around the ring for each would take forever.
    Index remove(Index corner)
    {
        const Index previous = before_[corner];
        const Index next = after_[corner];
        after_[previous] = next;
        before_[next] = previous;
        if (isReflex_[corner])
            unmark(corner);
        for (const Index i : {previous, next})
            if (isReflex_[i] && turn(points_[before_[i]], points_[i], points_[after_[i]]) > 0.0)
                unmark(i);
        return areEarsRare_ ? previous : after_[next];
    }

    void unmark(Index corner)
    {
        isReflex_[corner] = false;
        --reflexLeft_;
    }

    std::vector<Point> points_;
    Index count_;
    std::vector<Index> before_, after_;
    std::vector<bool> isReflex_;
    std::size_t reflexLeft_ = 0;
    ReflexGrid grid_;
    std::size_t cost_ = 0;
    bool areEarsRare_ = false;
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
