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
        var (before, after, from) = (_velocity, new Vector2D(vx, vy), _place);
        (_place, _velocity) = (from + new Vector2D(dx, dy), after);
        Teller.CurveTo(from + (before * (seconds / 3.0)), _place - (after * (seconds / 3.0)), _place);
        return null;
    }
}
