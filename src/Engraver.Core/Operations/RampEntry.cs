using Engraver.Core.Sequencing;

namespace Engraver.Core.Operations;

/// <summary>Descents along the strokes of an operation: around a closed stroke to its start, there and back on an open one.</summary>
/// <param name="angleDegrees">Angle of descent, above 0 and below 90.</param>
/// <param name="maxErrorMm">Largest distance of a chord from its arc or curve.</param>
internal sealed class RampEntry(double angleDegrees, double maxErrorMm)
{
    /// <summary>A stroke that would be followed more often is too short for a ramp.</summary>
    private const double MostTurns = 100.0;

    private readonly double _slope = Math.Tan(angleDegrees * Math.PI / 180.0);

    /// <summary>Length of the descent in plan, mm.</summary>
    /// <param name="fall">Difference of the depths, mm; 0 or less for none.</param>
    public double LengthOf(double fall) => Math.Max(0.0, fall / _slope);

    /// <summary>The moves from the depth before to the start of the stroke at its depth.</summary>
    /// <param name="stroke">In plan.</param>
    /// <returns>Empty where there is nothing to descend; null for a stroke that is too short.</returns>
    public IReadOnlyList<StrokeMove>? To(IReadOnlyList<StrokeMove> stroke, bool isClosed, double before, double depth)
    {
        if (LengthOf(depth - before) is not (> 0.0 and var length)) return [];
        var chords = ChordPath.Of(stroke, maxErrorMm);
        var whole = chords.Sum(chord => chord.Segment.Length);
        if (whole * MostTurns < length) return null;
        return [.. ChordPath.Sloped(isClosed ? Around(chords, whole, length) : ThereAndBack(chords, whole, length), -before, -depth, StrokeRole.Ramp)];
    }

    private static IReadOnlyList<StrokeMove> Around(IReadOnlyList<StrokeMove> chords, double whole, double length)
    {
        var turns = Math.Max(1, (int)Math.Ceiling(length / whole));
        return ChordPath.Last([.. Enumerable.Range(0, turns).SelectMany(_ => chords)], length);
    }

    private static IReadOnlyList<StrokeMove> ThereAndBack(IReadOnlyList<StrokeMove> chords, double whole, double length)
    {
        var trips = Math.Max(1, (int)Math.Ceiling(length / (2.0 * whole)));
        var there = ChordPath.First(chords, length / (2.0 * trips));
        var back = ChordPath.Reversed(there);
        return [.. Enumerable.Range(0, trips).SelectMany(_ => there.Concat(back))];
    }
}
