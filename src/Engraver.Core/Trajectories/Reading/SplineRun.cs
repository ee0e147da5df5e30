using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>A uniform Catmull-Rom spline: the first and the last row only turn the ends; between the others u runs from 0 to 1 through 1/2 (2 p1 + (p2 - p0) u + (2 p0 - 5 p1 + 4 p2 - p3) u^2 + (3 p1 - p0 - 3 p2 + p3) u^3).</summary>
/// <param name="start">What the points count from.</param>
/// <param name="isRelative">The machine stands there: the second row must be 0.</param>
internal sealed class SplineRun(Point2D start, bool isRelative, TrajectoryTeller teller) : TrajectoryRun(teller)
{
    private Point2D _before;
    private Point2D _from;
    private Point2D _to;
    private long _points;

    public override Diagnostic? End() => _points >= 4 ? null : Wrong(Wording.Get("Xps.TooFewLines"));

    protected override Diagnostic? Run(string words)
    {
        if (Numbers(words) is not [var x, var y, _]) return Unreadable(words);
        var point = new Point2D(start.X + x, start.Y + y);
        _points++;
        if (_points == 2 && isRelative && point != start) return Wrong(Wording.Get("Xps.StartNotZero"));
        if (_points == 2) Teller.GoTo(point);
        if (_points >= 4) Span(_before, _from, _to, point);
        (_before, _from, _to) = (_from, _to, point);
        return null;
    }

    private void Span(Point2D a, Point2D b, Point2D c, Point2D d)
    {
        var leaving = ((2.0 * a.X) - (5.0 * b.X) + (4.0 * c.X) - d.X, (2.0 * a.Y) - (5.0 * b.Y) + (4.0 * c.Y) - d.Y);
        var arriving = ((2.0 * d.X) - (5.0 * c.X) + (4.0 * b.X) - a.X, (2.0 * d.Y) - (5.0 * c.Y) + (4.0 * b.Y) - a.Y);
        Teller.CurveTo(leaving, arriving, c, u => new Point2D(On(u, a.X, b.X, c.X, d.X), On(u, a.Y, b.Y, c.Y, d.Y)));
    }

    private static double On(double u, double p0, double p1, double p2, double p3) =>
        ((2.0 * p1) + (u * ((p2 - p0) + (u * ((2.0 * p0) - (5.0 * p1) + (4.0 * p2) - p3 + (u * ((3.0 * p1) - p0 - (3.0 * p2) + p3))))))) / 2.0;
}
