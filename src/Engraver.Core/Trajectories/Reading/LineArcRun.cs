using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Lines and arcs: a line moves to a position counted from the start; an arc continues in the direction of the previous element.</summary>
/// <remarks>The header states the direction of the first element and the largest turn between two elements; the elements must comply with both
/// (sace-xps-agie.md 2.2).</remarks>
internal sealed class LineArcRun : TrajectoryRun
{
    /// <summary>Turns below this are due to rounding, degrees: of a line of a micrometre whose ends are written to a picometre.</summary>
    private const double Rounding = 0.0001;

    /// <summary>The angle of a file without turns, and the largest turn that does not count as a corner, degrees.</summary>
    private const double UsualAngle = 0.01;
    private const double CornerAngle = 0.5;

    /// <summary>Largest sweep of one arc, degrees: ten turns.</summary>
    private const double MaxSweep = 3600.0;

    private readonly Point2D _start;
    private Point2D _place;
    private double? _heading;
    private (double Degrees, int Line) _allowed = (UsualAngle, 0);
    private (double Degrees, int Line) _turned;

    public LineArcRun(Point2D start, TrajectoryTracer teller)
        : base(teller)
    {
        _start = _place = start;
        teller.GoTo(start);
    }

    public override Diagnostic? End()
    {
        if (_turned.Degrees > _allowed.Degrees + Rounding) Differ(AngleText(_allowed.Degrees), Wording.Get("Xps.AngleNeeded", AngleText(_turned.Degrees), _turned.Line), _allowed.Line > 0 ? _allowed.Line : _turned.Line);
        else if (_allowed.Degrees > CornerAngle || _allowed.Degrees < UsualAngle) Differ(AngleText(_allowed.Degrees), Wording.Get("Xps.Between", UsualAngle, CornerAngle), _allowed.Line);
        return null;
    }

    protected override Diagnostic? Run(string words)
    {
        var parts = words.Split('=');
        switch (parts[0].Trim(), parts.Length == 2 ? Numbers(parts[1]) : null)
        {
            case ("FirstTangent", [var degrees]):
                _heading = degrees * Math.PI / 180.0;
                return null;
            case ("DiscontinuityAngle", [var degrees]):
                _allowed = (degrees, Line);
                return null;
            case ("Line", [var x, var y]):
                LineTo(new Point2D(_start.X + x, _start.Y + y));
                return null;
            case ("Arc", [var radius, var sweep]) when radius > 0.0 && sweep != 0.0 && Math.Abs(sweep) <= MaxSweep:
                Arc(radius, sweep * Math.PI / 180.0);
                return null;
            default: return Unreadable(words);
        }
    }

    private void LineTo(Point2D end)
    {
        var heading = Math.Atan2(end.Y - _place.Y, end.X - _place.X);
        if (_heading is { } before && end != _place && Math.Abs(Math.IEEERemainder(heading - before, 2.0 * Math.PI)) * 180.0 / Math.PI is var turn && turn > _turned.Degrees) _turned = (turn, Line);
        _heading = heading;
        Tracer.LineTo(_place = end);
    }

    /// <summary>In quarters of a turn at most, as the judges require arcs.</summary>
    private void Arc(double radius, double sweep)
    {
        var (side, heading) = (Math.Sign(sweep), _heading ?? 0.0);
        var (x, y) = (_place.X - (side * radius * Math.Sin(heading)), _place.Y + (side * radius * Math.Cos(heading)));
        var from = heading - (side * Math.PI / 2.0);
        var parts = (int)Math.Ceiling(Math.Abs(sweep) / (Math.PI / 2.0));
        for (var i = 0; i < parts; i++) Tracer.ArcTo(new ArcSegment(new Point2D(x, y), radius, Angle.FromRadians(from + (sweep * i / parts)), Angle.FromRadians(sweep / parts)));
        (_place, _heading) = (new Point2D(x + (radius * Math.Cos(from + sweep)), y + (radius * Math.Sin(from + sweep))), heading + sweep);
    }

    private static string AngleText(double degrees) => $"DiscontinuityAngle = {FactText.Of(degrees)}";
}
