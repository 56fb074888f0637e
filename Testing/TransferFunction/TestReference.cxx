// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
// Random states on random samples against a direct evaluation, written from the definition alone:
// it works on its own description of the regions, in double precision, one sample at a time.
#include "ModelTesting.h"

#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

namespace
{
using Point = std::array<double, 2>;
const double Pi = std::acos(-1.0);

struct Region
{
  int Id;
  std::string Shape;
  Point Center;
  Point Size;
  double Angle;
  std::vector<Point> Points;
  std::string Falloff;
  double Width;
  std::array<double, 3> Color;
  double Opacity;
  bool Visible;
  int Tertiary; // attribute T0, T1, or -1
  std::vector<std::vector<double>> OpacityNodes;
  std::vector<std::vector<double>> ColorNodes;
};

struct Definition
{
  Point Low;
  Point High;
  bool Over;
  std::vector<Region> Regions;
};

class Generator
{
public:
  explicit Generator(unsigned seed)
    : Random(seed)
  {
  }
  double Uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  int Integer(int low, int high)
  {
    return std::uniform_int_distribution<int>(low, high)(this->Random);
  }
  Point InAxes(const Definition& d, double margin)
  {
    Point p;
    for (int a = 0; a < 2; ++a)
    {
      const double width = d.High[a] - d.Low[a];
      p[a] = this->Uniform(d.Low[a] - margin * width, d.High[a] + margin * width);
    }
    return p;
  }
  std::vector<std::vector<double>> Nodes(size_t columns)
  {
    std::vector<std::vector<double>> nodes;
    double value = this->Uniform(-2, 2);
    double before = value - 1;
    const int count = this->Integer(1, 6);
    for (int i = 0; i < count; ++i)
    {
      std::vector<double> node = { value };
      while (node.size() < columns)
      {
        node.push_back(this->Uniform(0, 1));
      }
      nodes.push_back(node);
      const bool step = value != before && this->Integer(0, 3) == 0;
      before = value;
      value += step ? 0.0 : this->Uniform(0.1, 2);
    }
    return nodes;
  }
  Definition Make()
  {
    Definition d;
    for (int a = 0; a < 2; ++a)
    {
      const double scale = std::pow(10.0, this->Integer(-6, 6));
      d.Low[a] = scale * this->Uniform(-5, 5);
      d.High[a] = d.Low[a] + scale * this->Uniform(0.1, 3);
    }
    d.Over = this->Integer(0, 1) == 1;
    const int count = this->Integer(1, 8);
    for (int i = 0; i < count; ++i)
    {
      Region r;
      r.Id = i * 7 + 3;
      r.Shape = std::array<const char*, 4>{ "ellipse", "rectangle", "triangle",
        "polygon" }[this->Integer(0, 3)];
      r.Center = this->InAxes(d, 0.1);
      for (int a = 0; a < 2; ++a)
      {
        r.Size[a] = (d.High[a] - d.Low[a]) * std::pow(10.0, this->Uniform(-2, 0.2));
      }
      r.Angle = this->Uniform(-400, 400);
      const int points = r.Shape == "triangle" ? 3 : this->Integer(3, 12);
      for (int k = 0; k < points; ++k)
      {
        r.Points.push_back(this->InAxes(d, 0.1));
      }
      r.Falloff = std::array<const char*, 4>{ "constant", "linear", "smooth",
        "gaussian" }[this->Integer(0, 3)];
      r.Width = this->Uniform(0.01, 1);
      r.Color = { { this->Uniform(0, 1), this->Uniform(0, 1), this->Uniform(0, 1) } };
      r.Opacity = this->Uniform(0, 1);
      r.Visible = this->Integer(0, 5) > 0;
      r.Tertiary = this->Integer(-1, 1);
      r.OpacityNodes = this->Nodes(2);
      if (this->Integer(0, 1))
      {
        r.ColorNodes = this->Nodes(4);
      }
      d.Regions.push_back(r);
    }
    return d;
  }

private:
  std::mt19937 Random;
};

template <typename List>
std::string Numbers(const List& list)
{
  std::ostringstream out;
  out << std::setprecision(17) << "[";
  for (size_t i = 0; i < list.size(); ++i)
  {
    out << (i ? "," : "") << list[i];
  }
  out << "]";
  return out.str();
}

template <typename Rows>
std::string Lists(const Rows& rows)
{
  std::string out;
  for (const auto& row : rows)
  {
    out += (out.empty() ? "" : ",") + Numbers(row);
  }
  return "[" + out + "]";
}

std::string ToJson(const Definition& d)
{
  std::ostringstream out;
  out << std::setprecision(17) << R"({"format":"transfer-function-combination","version":1,)"
      << R"("primary":{"array":"P","range":)" << Numbers(Point{ d.Low[0], d.High[0] })
      << R"(},"secondary":{"array":"S","range":)" << Numbers(Point{ d.Low[1], d.High[1] })
      << R"(},"blend":")" << (d.Over ? "over" : "mix") << R"(","regions":[)";
  for (const Region& r : d.Regions)
  {
    out << (&r == &d.Regions[0] ? "" : ",") << R"({"id":)" << r.Id << R"(,"visible":)"
        << (r.Visible ? "true" : "false") << R"(,"shape":{"type":")" << r.Shape << "\",";
    if (r.Shape == "ellipse" || r.Shape == "rectangle")
    {
      out << R"("center":)" << Numbers(r.Center)
          << (r.Shape == "ellipse" ? R"(,"radii":)" : R"(,"halfsize":)") << Numbers(r.Size)
          << R"(,"angle":)" << r.Angle;
    }
    else
    {
      out << R"("points":)" << Lists(r.Points);
    }
    out << R"(},"falloff":{"type":")" << r.Falloff << R"(","width":)" << r.Width << R"(},"color":)"
        << Numbers(r.Color) << R"(,"opacity":)" << r.Opacity << R"(,"tertiary":)";
    if (r.Tertiary < 0)
    {
      out << "null}";
      continue;
    }
    out << R"({"array":"T)" << r.Tertiary << R"(","opacity":)" << Lists(r.OpacityNodes);
    if (!r.ColorNodes.empty())
    {
      out << R"(,"color":)" << Lists(r.ColorNodes);
    }
    out << "}}";
  }
  out << "]}";
  return out.str();
}

// Linear between nodes, ends extended, the later node of a step from its value on.
std::vector<double> Function(const std::vector<std::vector<double>>& nodes, double v)
{
  if (v < nodes.front()[0])
  {
    return { nodes.front().begin() + 1, nodes.front().end() };
  }
  size_t last = 0;
  while (last + 1 < nodes.size() && nodes[last + 1][0] <= v)
  {
    ++last;
  }
  std::vector<double> result(nodes[last].begin() + 1, nodes[last].end());
  if (last + 1 < nodes.size())
  {
    const auto& a = nodes[last];
    const auto& b = nodes[last + 1];
    for (size_t k = 0; k < result.size(); ++k)
    {
      result[k] = a[k + 1] + (v - a[0]) / (b[0] - a[0]) * (b[k + 1] - a[k + 1]);
    }
  }
  return result;
}

// Distance to the nearest edge; negative outside.
double EdgeDistance(const std::vector<Point>& p, double x, double y)
{
  double nearest = HUGE_VAL;
  bool inside = false;
  for (size_t i = 0; i < p.size(); ++i)
  {
    const Point a = p[i];
    const Point b = p[(i + 1) % p.size()];
    const Point u = { { b[0] - a[0], b[1] - a[1] } };
    const double length2 = u[0] * u[0] + u[1] * u[1];
    const double t = ((x - a[0]) * u[0] + (y - a[1]) * u[1]) / length2;
    const double e = t <= 0 ? std::hypot(x - a[0], y - a[1])
      : t >= 1              ? std::hypot(x - b[0], y - b[1])
                            : std::abs(u[0] * (y - a[1]) - u[1] * (x - a[0])) / std::sqrt(length2);
    nearest = std::min(nearest, e);
    if ((a[0] > x) != (b[0] > x) && a[1] + (x - a[0]) * u[1] / u[0] > y)
    {
      inside = !inside;
    }
  }
  return inside ? nearest : -nearest;
}

struct Expected
{
  std::array<double, 3> Color = { { 0, 0, 0 } };
  double Alpha = 0;
  std::vector<double> Contribution; // by region
  bool NearBorder = false;          // where rounding decides between inside and outside
};

Expected Direct(const Definition& d, const std::vector<double>& maximumEdgeDistance, Point value,
  const std::array<double, 2>& tertiary)
{
  Expected result;
  result.Contribution.assign(d.Regions.size(), 0);
  if (!(value[0] >= d.Low[0] && value[0] <= d.High[0] && value[1] >= d.Low[1] &&
        value[1] <= d.High[1]))
  {
    return result;
  }
  const Point width = { { d.High[0] - d.Low[0], d.High[1] - d.Low[1] } };
  const auto axis = [&](const Point& p) {
    return Point{ { (p[0] - d.Low[0]) / width[0], (p[1] - d.Low[1]) / width[1] } };
  };
  const Point p = axis(value);
  double transparency = 1;
  double sum = 0;
  for (size_t j = 0; j < d.Regions.size(); ++j)
  {
    const Region& r = d.Regions[j];
    if (!r.Visible)
    {
      continue;
    }
    double distance = 0;
    if (r.Shape == "ellipse" || r.Shape == "rectangle")
    {
      const Point c = axis(r.Center);
      const double t = r.Angle * Pi / 180;
      const double u = std::cos(t) * (p[0] - c[0]) + std::sin(t) * (p[1] - c[1]);
      const double v = -std::sin(t) * (p[0] - c[0]) + std::cos(t) * (p[1] - c[1]);
      const double rx = r.Size[0] / width[0];
      const double ry = r.Size[1] / width[1];
      distance = r.Shape == "ellipse" ? std::sqrt(u / rx * (u / rx) + v / ry * (v / ry))
                                      : std::max(std::abs(u) / rx, std::abs(v) / ry);
    }
    else
    {
      std::vector<Point> points;
      for (const Point& q : r.Points)
      {
        points.push_back(axis(q));
      }
      double largest = maximumEdgeDistance[j];
      if (r.Shape == "triangle")
      {
        double sides[3];
        for (int k = 0; k < 3; ++k)
        {
          sides[k] = std::hypot(points[(k + 1) % 3][0] - points[k][0],
            points[(k + 1) % 3][1] - points[k][1]);
        }
        const double area = std::abs((points[1][0] - points[0][0]) * (points[2][1] - points[0][1]) -
                              (points[1][1] - points[0][1]) * (points[2][0] - points[0][0])) /
          2;
        largest = 2 * area / (sides[0] + sides[1] + sides[2]);
      }
      distance = std::max(0.0, 1 - EdgeDistance(points, p[0], p[1]) / largest);
    }
    result.NearBorder = result.NearBorder || std::abs(distance - 1) < 1e-9;
    if (distance > 1)
    {
      continue;
    }
    const double linear = std::min(1.0, (1 - distance) / r.Width);
    double alpha = r.Opacity *
      (r.Falloff == "constant"    ? 1
          : r.Falloff == "linear" ? linear
          : r.Falloff == "smooth" ? linear * linear * (3 - 2 * linear)
                                  : std::exp(-distance * distance / (2 * r.Width * r.Width)));
    std::vector<double> color(r.Color.begin(), r.Color.end());
    if (r.Tertiary >= 0)
    {
      const double v = tertiary[r.Tertiary];
      alpha *= std::isnan(v) ? 0 : Function(r.OpacityNodes, v)[0];
      color = r.ColorNodes.empty() || std::isnan(v) ? color : Function(r.ColorNodes, v);
    }
    const double contribution = d.Over ? alpha * transparency : alpha;
    result.Contribution[j] = contribution;
    for (int c = 0; c < 3; ++c)
    {
      result.Color[c] += contribution * color[c];
    }
    sum += contribution;
    transparency *= 1 - alpha;
  }
  result.Alpha = 1 - transparency;
  for (int c = 0; c < 3; ++c)
  {
    result.Color[c] = sum > 0 ? result.Color[c] / sum : 0;
  }
  return result;
}

void CheckSeed(unsigned seed, int samples)
{
  Generator generator(seed);
  const Definition d = generator.Make();
  const vtkTFCCompiledModel model = ModelTesting::Compile(ToJson(d));
  const vtkTFCClassifier classifier(model);
  // The tertiary attributes in order of first use, and E of the polygons (checked elsewhere).
  std::vector<int> order;
  std::vector<double> largest(d.Regions.size(), 1);
  for (size_t j = 0; j < d.Regions.size(); ++j)
  {
    const Region& r = d.Regions[j];
    if (r.Visible && r.Tertiary >= 0 &&
      std::find(order.begin(), order.end(), r.Tertiary) == order.end())
    {
      order.push_back(r.Tertiary);
    }
    for (const auto& compiled : model.Regions)
    {
      largest[j] = compiled.Id == r.Id ? compiled.MaximumEdgeDistance : largest[j];
    }
  }
  for (int i = 0; i < samples; ++i)
  {
    const Point value = generator.InAxes(d, 0.02);
    std::array<double, 2> tertiary = { { generator.Uniform(-4, 12), generator.Uniform(-4, 12) } };
    if (generator.Integer(0, 9) == 0)
    {
      tertiary[0] = std::nan("");
    }
    std::vector<double> values = { value[0], value[1] };
    for (const int t : order)
    {
      values.push_back(tertiary[t]);
    }
    const auto found = ModelTesting::Evaluate(classifier, values);
    const Expected expected = Direct(d, largest, value, tertiary);
    if (expected.NearBorder)
    {
      continue;
    }
    ASSERT_NEAR(found.RGBA[3], expected.Alpha, 2e-7) << "seed " << seed << " sample " << i;
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(found.RGBA[c], expected.Color[c], 2e-7) << "seed " << seed << " sample " << i;
    }
    double best = 0;
    double chosen = 0;
    for (size_t j = 0; j < d.Regions.size(); ++j)
    {
      best = std::max(best, expected.Contribution[j]);
      chosen = found.Region == d.Regions[j].Id ? expected.Contribution[j] : chosen;
    }
    ASSERT_NEAR(chosen, best, 1e-9) << "seed " << seed << " sample " << i;
    ASSERT_EQ(found.Region == 0, best == 0);
  }
}
}

TEST(Reference, RandomStatesAndSamples)
{
  for (unsigned seed = 1; seed <= 400; ++seed)
  {
    CheckSeed(seed, 250);
    if (::testing::Test::HasFatalFailure())
    {
      return;
    }
  }
}
