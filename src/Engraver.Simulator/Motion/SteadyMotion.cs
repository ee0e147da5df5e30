namespace Engraver.Simulator.Motion;

/// <summary>Motion at constant speed in which no other event can occur: vector paths within a segment and independent moves. The positions of its samples are
/// given in closed form.</summary>
/// <remarks>Everything else is stepped sample by sample: gears, cams, contours, tangents, smoothing, lag, switches, homing, ramps, the ends of segments, and
/// the last samples before a change.</remarks>
internal sealed class SteadyMotion(MotionKernel kernel)
{
    /// <summary>Spans of fewer samples are stepped: a jump takes as much time as several samples, and short spans are evaluated sample by sample.</summary>
    public const long Shortest = 128;

    private readonly List<VectorPlane> _planes = [];
    private readonly List<Axis> _moves = [];

    /// <summary>Number of samples from now on at constant speed; 0 when there are fewer than <see cref="Shortest"/>.</summary>
    public long Samples(long atMost)
    {
        if (atMost < Shortest) return 0;
        _planes.Clear();
        _moves.Clear();
        var samples = atMost;
        foreach (var plane in kernel.Planes)
        {
            if (plane.IsRunning) _planes.Add(plane);
            if (plane.IsRunning) samples = Math.Min(samples, plane.SteadySamples(samples) is > 0 and var steady && ArePlain(plane.Axes) ? steady : 0);
        }

        foreach (var axis in kernel.Axes)
        {
            if (axis.IsMoving) _moves.Add(axis);
            if (axis.IsMoving) samples = Math.Min(samples, axis.SteadySamples(samples) is > 0 and var steady && ArePlain([axis]) ? steady : 0);
        }

        return samples < Shortest || _planes.Count + _moves.Count == 0 || kernel.HasFollowers ? 0 : samples;
    }

    /// <summary>Sets every position to its value after the given number of <see cref="Samples"/>, so that conditions can be tested; <see cref="Pass"/> must
    /// follow before time advances.</summary>
    public void Place(long samples)
    {
        foreach (var plane in _planes) plane.PlaceSteady(samples);
        foreach (var axis in _moves) axis.PlaceSteady(samples);
    }

    /// <summary>A moving axis has reached a limit.</summary>
    public bool IsAtLimit()
    {
        foreach (var plane in _planes)
        {
            if (!AreFree(plane.Axes)) return true;
        }

        return !_moves.TrueForAll(axis => AreFree([axis]));
    }

    /// <summary>Advances by the given number of samples.</summary>
    public void Pass(long samples)
    {
        foreach (var plane in _planes)
        {
            plane.Profile.PassSteady(samples);
            plane.PlaceSteady(0);
        }

        foreach (var axis in _moves) axis.PassSteady(samples);
        kernel.FollowAll();
    }

    /// <summary>The positions, from now on, of all moving axes.</summary>
    public SteadyCourse[] Courses() => [.. _planes.Select(plane => (SteadyCourse)plane.Course()), .. _moves.Select(axis => axis.Course())];

    private static bool ArePlain(ReadOnlySpan<Axis> axes)
    {
        foreach (var axis in axes)
        {
            if (!axis.IsPlain) return false;
        }

        return AreFree(axes);
    }

    private static bool AreFree(ReadOnlySpan<Axis> axes)
    {
        foreach (var axis in axes)
        {
            if (axis.RunsIntoLimit(1, out _) || axis.RunsIntoLimit(-1, out _)) return false;
        }

        return true;
    }
}
