using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Workbench.Composition;

/// <summary>Compares where the motors were with the drawing: a servo that is blocked or too weak leaves the path that was commanded. Lengths in
/// millimetres.</summary>
/// <remarks>While the motors are where they were commanded, the judge of the commanded path knows all of it, and nothing is computed here. Not thread
/// safe.</remarks>
/// <param name="drawing">Makes the judge of places, which is needed only when a motor is off its command.</param>
internal sealed class MotorJudge(Func<ITraceJudge> drawing)
{
    /// <summary>A motor that is free again may cross more than this between two samples; the places between are judged too.</summary>
    private const double LargestWay = 0.05;

    private const int MostSteps = 400;

    /// <summary>Between two samples of a record a motor goes straight, seconds; between two polls it goes along the path.</summary>
    private const double LongestSample = 0.005;

    private ITraceJudge? _places;
    private TraceSample? _last;

    /// <summary>The largest distance of the motors from their command while the tool cut; null while nobody has told it.</summary>
    public double? Following { get; private set; }

    /// <summary>Where that was, by the commanded path.</summary>
    public Point2D? FollowingAt { get; private set; }

    /// <summary>The largest distance of a cutting motor from the drawing where it was off its command; 0 where it never was.</summary>
    public double Deviation => Verdict?.MaxDeviation ?? 0.0;

    public Point2D? DeviationAt => Verdict?.DeviationAt?.Place;

    private TraceVerdict? Verdict => _places?.Verdict();

    /// <param name="commanded">Where the axes were commanded to be.</param>
    /// <param name="motor">Where the motors were at the same time; its distance from the command is known.</param>
    public void Add(in TraceSample commanded, in TraceSample motor)
    {
        if (motor.FollowingMm is not { } following) return;
        if (motor.Cutting && (Following is not { } largest || following > largest)) (Following, FollowingAt) = (following, commanded.Place);
        if (following > 0.0 || _last is { FollowingMm: > 0.0 }) Judge(motor);
        _last = motor;
    }

    /// <summary>The motors followed their command along here.</summary>
    public void Followed(bool isCutting)
    {
        if (isCutting) Following ??= 0.0;
        _last = null;
    }

    private void Judge(in TraceSample motor)
    {
        _places ??= drawing();
        if (_last is { Cutting: true } before && motor.Cutting && motor.Seconds - before.Seconds <= LongestSample)
        {
            var steps = (int)Math.Min(MostSteps, before.Place.DistanceTo(motor.Place) / LargestWay);
            for (var i = 1; i < steps; i++) _places.Add(Between(before, motor, (double)i / steps));
        }

        _places.Add(motor);
    }

    private static TraceSample Between(in TraceSample from, in TraceSample to, double part) => to with
    {
        Seconds = from.Seconds + (part * (to.Seconds - from.Seconds)),
        XMm = from.XMm + (part * (to.XMm - from.XMm)),
        YMm = from.YMm + (part * (to.YMm - from.YMm)),
    };
}
