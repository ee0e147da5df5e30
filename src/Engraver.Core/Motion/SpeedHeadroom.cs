using Engraver.Core.Machines;
using Engraver.Core.Motion.Planning;

namespace Engraver.Core.Motion;

/// <summary>The factor by which sequences may be cut faster than planned. A factor scales the speed and not the acceleration, so a bend that the plan allows
/// may be too sharp for it.</summary>
public static class SpeedHeadroom
{
    private const double Step = 0.1;

    /// <summary>The largest factor, in steps of a tenth, at which every limit that the plan keeps is still kept. Where the plan changes its speed on the way
    /// there is none: a brake would be too short.</summary>
    /// <param name="fastest">The controller's fastest speed along a path, counts/s.</param>
    /// <param name="most">Upper limit of the factor.</param>
    /// <returns>At least 1: the plan itself.</returns>
    public static double Of(IEnumerable<VectorSequence> sequences, MachineProfile profile, double fastest, double most)
    {
        ArgumentNullException.ThrowIfNull(sequences);
        ArgumentNullException.ThrowIfNull(profile);
        var (headroom, limits) = (most, PathLimits.Of(profile));
        foreach (var sequence in sequences) headroom = Math.Min(headroom, sequence.HasOwnSpeeds ? 1.0 : Math.Min(fastest, FastestOf(sequence, limits)) / sequence.Speed);
        return Math.Max(1.0, Math.Floor((headroom / Step) + 1e-6) * Step);
    }

    /// <summary>The highest speed that arcs and joints allow, counts/s. A ramp on an arc is not counted: it is added there to v2/r, as in a hold.</summary>
    private static double FastestOf(VectorSequence sequence, PathLimits limits)
    {
        var (fastest, from, before, length) = (double.PositiveInfinity, sequence.Start, default(PathDirection?), 0.0);
        foreach (var segment in sequence.Segments)
        {
            var (first, last) = PathDirection.AtEnds(from, segment);
            if (segment.Kind == VectorSegmentKind.Arc) fastest = Math.Min(fastest, Math.Sqrt(limits.OnArcs * segment.Radius));
            if (before is { } direction) fastest = Math.Min(fastest, limits.SpeedThrough(limits.TurnOf(direction, first), Math.Min(length, segment.Length)));
            (before, from, length) = (last, segment.End, segment.Length);
        }

        return fastest;
    }
}
