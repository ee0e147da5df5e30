using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Positions, velocities and times, from rest: each row adds its displacements in its time by the cubic fixed by both velocities, and the last ends at rest.</summary>
internal sealed class PvtRun : TrajectoryRun
{
    private Point2D _place;
    private Vector2D _velocity;

    public PvtRun(Point2D start, TrajectoryTeller teller)
        : base(teller)
    {
        _place = start;
        teller.GoTo(start);
    }

    public override Diagnostic? End() => _velocity == default ? null : Wrong(Wording.Get("Xps.EndsInMotion"));

    protected override Diagnostic? Run(string words)
    {
        if (Numbers(words) is not [var seconds, var dx, var vx, var dy, var vy] || !(seconds > 0.0)) return Unreadable(words);
        var (from, way, before, after) = (_place, new Vector2D(dx, dy), _velocity, new Vector2D(vx, vy));
        var leaving = (way * 6.0) - (((before * 4.0) + (after * 2.0)) * seconds);
        var arriving = (((before * 2.0) + (after * 4.0)) * seconds) - (way * 6.0);
        (_place, _velocity) = (from + way, after);
        Teller.CurveTo((leaving.X, leaving.Y), (arriving.X, arriving.Y), _place, u =>
            from + (way * (u * u * (3.0 - (2.0 * u)))) + (before * (seconds * u * (1.0 - u) * (1.0 - u))) + (after * (seconds * u * u * (u - 1.0))));
        return null;
    }
}
