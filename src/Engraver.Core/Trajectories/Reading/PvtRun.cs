using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Positions, velocities and times, from rest: each row adds its displacements in its time by the cubic fixed by both velocities, and the last ends at
/// rest.</summary>
/// <remarks>The motion must not exceed the machine's feed or the acceleration of any axis, and the time of a row must match the mean of the speeds at its ends:
/// a time or a speed that does not match is reported.</remarks>
internal sealed class PvtRun : TrajectoryRun
{
    /// <summary>Tolerance of a speed, an acceleration or a distance, as a fraction, for a cubic that follows a bend and accelerates at the same time.</summary>
    private const double Share = 0.01;

    /// <summary>Distance that counts as zero, millimetres.</summary>
    private const double Nothing = 1e-6;

    /// <summary>Number of chords of a cubic for its length.</summary>
    private const int Chords = 64;

    private Point2D _place;
    private Vector2D _velocity;

    public PvtRun(Point2D start, TrajectoryTracer teller)
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
        Judge(from, before, seconds);
        Tracer.CurveTo(from + (before * (seconds / 3.0)), _place - (after * (seconds / 3.0)), _place);
        return null;
    }

    private void Judge(Point2D from, Vector2D before, double seconds)
    {
        var (machine, way, after) = (Tracer.Request.Machine, _place - from, _velocity);
        var feed = machine.FeedMmPerMinute / 60.0;
        var most = machine.Scale.Finer.LengthOf(machine.AccelerationCounts);
        if (after.Length > feed * (1.0 + Share)) Differ(Wording.Get("Xps.SpeedFound", after.Length), Wording.Get("Xps.MaxSpeed", feed));
        var (first, last) = ((way * (6.0 / (seconds * seconds))) - (before * (4.0 / seconds)) - (after * (2.0 / seconds)), (way * (-6.0 / (seconds * seconds))) + (before * (2.0 / seconds)) + (after * (4.0 / seconds)));
        var needed = new[] { first.X, first.Y, last.X, last.Y }.Max(Math.Abs);
        if (needed > most * (1.0 + Share)) Differ(Wording.Get("Xps.AccelerationFound", needed), Wording.Get("Xps.MaxAcceleration", most));
        var (length, expected) = (Length(from, before, seconds), (before.Length + after.Length) * seconds / 2.0);
        if (Math.Abs(length - expected) > (Share * length) + Nothing) Differ(Wording.Get("Xps.TimeFound", seconds), Wording.Get("Xps.TimeNeeded", seconds * length / expected));
    }

    private double Length(Point2D from, Vector2D before, double seconds)
    {
        var (length, last) = (0.0, from);
        var (leaving, arriving) = (from + (before * (seconds / 3.0)), _place - (_velocity * (seconds / 3.0)));
        for (var i = 1; i <= Chords; i++)
        {
            var (u, v) = ((double)i / Chords, 1.0 - ((double)i / Chords));
            double On(double a, double b, double c, double d) => (v * v * v * a) + (3.0 * v * v * u * b) + (3.0 * v * u * u * c) + (u * u * u * d);
            var next = new Point2D(On(from.X, leaving.X, arriving.X, _place.X), On(from.Y, leaving.Y, arriving.Y, _place.Y));
            (length, last) = (length + last.DistanceTo(next), next);
        }

        return length;
    }
}
