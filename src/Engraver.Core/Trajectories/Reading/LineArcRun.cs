using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Lines and arcs: a line goes to a place counted from the start; an arc goes on in the direction of the element before.</summary>
internal sealed class LineArcRun : TrajectoryRun
{
    private readonly Point2D _start;
    private Point2D _place;
    private double _heading;

    public LineArcRun(Point2D start, TrajectoryTeller teller)
        : base(teller)
    {
        _start = _place = start;
        teller.GoTo(start);
    }

    public override Diagnostic? End() => null;

    protected override Diagnostic? Run(string words)
    {
        var parts = words.Split('=');
        switch (parts[0].Trim(), parts.Length == 2 ? Numbers(parts[1]) : null)
        {
            case ("FirstTangent", [var degrees]):
                _heading = degrees * Math.PI / 180.0;
                return null;
            case ("DiscontinuityAngle", [_]): return null;
            case ("Line", [var x, var y]):
                Line(new Point2D(_start.X + x, _start.Y + y));
                return null;
            case ("Arc", [var radius, var sweep]) when radius > 0.0 && sweep != 0.0:
                Arc(radius, sweep * Math.PI / 180.0);
                return null;
            default: return Unreadable(words);
        }
    }

    private void Line(Point2D end)
    {
        _heading = Math.Atan2(end.Y - _place.Y, end.X - _place.X);
        Teller.LineTo(_place = end);
    }

    /// <summary>In quarters of a turn at most, as the judges take arcs.</summary>
    private void Arc(double radius, double sweep)
    {
        var side = Math.Sign(sweep);
        var (x, y) = (_place.X - (side * radius * Math.Sin(_heading)), _place.Y + (side * radius * Math.Cos(_heading)));
        var from = _heading - (side * Math.PI / 2.0);
        var parts = (int)Math.Ceiling(Math.Abs(sweep) / (Math.PI / 2.0));
        for (var i = 0; i < parts; i++) Teller.ArcTo(new ArcSegment(new Point2D(x, y), radius, Angle.FromRadians(from + (sweep * i / parts)), Angle.FromRadians(sweep / parts)));
        (_place, _heading) = (new Point2D(x + (radius * Math.Cos(from + sweep)), y + (radius * Math.Sin(from + sweep))), _heading + sweep);
    }
}
