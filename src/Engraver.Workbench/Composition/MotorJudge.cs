using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Workbench.Composition;

/// <summary>Compares the motor positions with the drawing: a blocked or weak servo leaves the commanded path. Lengths in millimetres.</summary>
/// <remarks>While the motors are at their commanded positions nothing is computed, because the judge of the commanded path covers them. Not thread
/// safe.</remarks>
/// <param name="drawing">Creates the position judge, needed only if a motor deviates from its command.</param>
internal sealed class MotorJudge(Func<ITraceJudge> drawing)
{
    /// <summary>Maximum distance between two judged positions: a released motor may move farther between two samples, and intermediate positions are judged
    /// too.</summary>
    private const double MaxStepLength = 0.05;

    private const int MaxSteps = 400;

    /// <summary>Maximum sample interval for straight interpolation, seconds; between two polls a motor follows the path.</summary>
    private const double MaxSampleSeconds = 0.005;

    private ITraceJudge? _places;
    private TraceSample? _last;

    /// <summary>Largest following error while the tool cut; null before the first sample.</summary>
    public double? Following { get; private set; }

    /// <summary>Position of that error on the commanded path.</summary>
    public Point2D? FollowingAt { get; private set; }

    /// <summary>Largest deviation from the drawing while cutting with a following error; 0 if there was none.</summary>
    public double Deviation => Verdict?.MaxDeviation ?? 0.0;

    /// <summary>The same where corners were rounded within the corner tolerance.</summary>
    public double CornerDeviation => Verdict?.CornerDeviation ?? 0.0;

    public Point2D? DeviationAt => Verdict?.DeviationAt?.Place;

    private TraceVerdict? Verdict => _places?.Verdict();

    /// <param name="commanded">Commanded position.</param>
    /// <param name="motor">Motor position at the same time.</param>
    public void Add(in TraceSample commanded, in TraceSample motor)
    {
        if (motor.FollowingMm is not { } following) return;
        if (motor.Cutting && (Following is not { } largest || following > largest)) (Following, FollowingAt) = (following, commanded.Place);
        if (following > 0.0 || _last is { FollowingMm: > 0.0 }) Judge(motor);
        _last = motor;
    }

    /// <summary>Notes a span without following error.</summary>
    public void AddSpan(bool isCutting)
    {
        if (isCutting) Following ??= 0.0;
        _last = null;
    }

    private void Judge(in TraceSample motor)
    {
        _places ??= drawing();
        if (_last is { Cutting: true } before && motor.Cutting && motor.Seconds - before.Seconds <= MaxSampleSeconds)
        {
            var steps = (int)Math.Min(MaxSteps, before.Place.DistanceTo(motor.Place) / MaxStepLength);
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
