using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>A uniform Catmull-Rom spline: the first and the last row only set the directions at the ends; between the others u runs from 0 to 1 through 1/2 (2
/// p1 + (p2 - p0) u + (2 p0 - 5 p1 + 4 p2 - p3) u^2 + (3 p1 - p0 - 3 p2 + p3) u^3), which leaves p1 with (p2 - p0) / 2 and arrives with (p3 - p1) /
/// 2.</summary>
/// <param name="start">Origin of the points.</param>
/// <param name="isRelative">True when this is the machine position: the second row must be 0.</param>
internal sealed class SplineRun(Point2D start, bool isRelative, TrajectoryTracer teller) : TrajectoryRun(teller)
{
    private Point2D _before;
    private Point2D _from;
    private Point2D _to;
    private double _z;
    private long _points;

    public override Diagnostic? End() => _points >= 4 ? null : Wrong(Wording.Get("Xps.TooFewLines"));

    protected override Diagnostic? Run(string words)
    {
        if (Numbers(words) is not [var x, var y, var z]) return Unreadable(words);
        var point = new Point2D(start.X + x, start.Y + y);
        _points++;
        if (_points == 1) _z = z;
        if (_points > 1 && z != _z && Tracer.Request.IsLevel) Differ($"z {FactText.Of(z)}", $"z {FactText.Of(_z)}");
        if (_points == 2 && isRelative && (point != start || z != 0.0)) return Wrong(Wording.Get("Xps.SecondLineNotZero"));
        if (_points == 2) Tracer.GoTo(point);
        if (_points >= 4) Tracer.CurveTo(_from + ((_to - _before) * (1.0 / 6.0)), _to - ((point - _from) * (1.0 / 6.0)), _to);
        (_before, _from, _to) = (_from, _to, point);
        return null;
    }
}
