using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Plots;

/// <summary>The trace of a run as columns. Speed and acceleration are determined from the positions, which are rounded to counts, and are therefore averaged
/// over a short time.</summary>
public static class TraceSeries
{
    /// <summary>Time over which the speed is averaged, seconds: just below 10 ms, so that one poll of that length is enough.</summary>
    private const double SpeedWindow = 0.0099;

    /// <summary>Time over which the change of the velocity is averaged, seconds.</summary>
    private const double AccelerationWindow = 0.0299;

    private const double SecondsPerMinute = 60.0;

    private const double Percent = 100.0;

    /// <summary>The series of a run, with its lag where it can be compared with the plan.</summary>
    public static MotionSeries From(RecordedRun run)
    {
        ArgumentNullException.ThrowIfNull(run);
        return From(run.Trace, run.Job.Motion.Program is { } program ? RunLag.Of(program, run.Trace) : null);
    }

    /// <param name="lag">Of this trace; null where it is not known.</param>
    public static MotionSeries From(RunTrace trace, RunLag? lag = null)
    {
        ArgumentNullException.ThrowIfNull(trace);
        var places = trace.Places;
        var (count, start) = (places.Count, places.Count > 0 ? places[0].Seconds : 0.0);
        var (seconds, path) = (new double[count], new double[count]);
        for (var i = 0; i < count; i++)
        {
            seconds[i] = Math.Max(places[i].Seconds - start, i > 0 ? seconds[i - 1] : 0.0);
            path[i] = i > 0 ? path[i - 1] + places[i].Place.DistanceTo(places[i - 1].Place) : 0.0;
        }

        var velocities = Rates(seconds, SpeedWindow, i => places[i].Place - Point2D.Origin);
        var accelerations = Rates(seconds, AccelerationWindow, i => velocities[i]);
        List<(PlotQuantity, double[])> values =
        [
            (PlotQuantity.Speed, [.. velocities.Select(velocity => velocity.Length * SecondsPerMinute)]),
            (PlotQuantity.AccelerationX, [.. accelerations.Select(acceleration => acceleration.X)]),
            (PlotQuantity.AccelerationY, [.. accelerations.Select(acceleration => acceleration.Y)]),
            (PlotQuantity.Deviation, [.. places.Select(place => place.DeviationMm)]),
        ];
        AddKnown(PlotQuantity.FollowingError, place => place.FollowingMm);
        AddKnown(PlotQuantity.FeedOverride, place => place.Conditions.FeedRatio * Percent);
        AddKnown(PlotQuantity.LinkLoad, place => place.Conditions.LinkLoad * Percent);
        if (lag is not null) values.Add((PlotQuantity.Lag, [.. lag.Behind]));
        return new MotionSeries(seconds, path, null, values);

        void AddKnown(PlotQuantity quantity, Func<RunTracePlace, double?> valueOf)
        {
            if (places.Any(place => valueOf(place) is not null)) values.Add((quantity, [.. places.Select(place => valueOf(place) ?? double.NaN)]));
        }
    }

    /// <summary>Rate of change of a vector at each sample over the time before it.</summary>
    private static Vector2D[] Rates(double[] seconds, double window, Func<int, Vector2D> vectorOf)
    {
        var rates = new Vector2D[seconds.Length];
        for (var (i, first) = (1, 0); i < seconds.Length; i++)
        {
            while (first + 1 < i && seconds[i] - seconds[first + 1] >= window) first++;
            if (seconds[i] > seconds[first]) rates[i] = (vectorOf(i) - vectorOf(first)) * (1.0 / (seconds[i] - seconds[first]));
        }

        return rates;
    }
}
