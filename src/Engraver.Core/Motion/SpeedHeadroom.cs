using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The factor by which sequences may be cut faster than planned. A factor scales the speed and not the acceleration, so a bend that the plan allows
/// may be too sharp for it.</summary>
public static class SpeedHeadroom
{
    private const double Step = 0.1;

    /// <summary>The largest factor, in steps of a tenth, at which every limit that the plan keeps is still kept.</summary>
    /// <param name="fastest">The controller's fastest speed along a path, counts/s.</param>
    /// <param name="most">Upper limit of the factor.</param>
    /// <returns>At least 1: the plan itself.</returns>
    public static double Of(IEnumerable<VectorSequence> sequences, MachineProfile profile, double fastest, double most)
    {
        ArgumentNullException.ThrowIfNull(sequences);
        ArgumentNullException.ThrowIfNull(profile);
        var headroom = most;
        foreach (var sequence in sequences)
        {
            headroom = Math.Min(Math.Min(headroom, fastest / sequence.Speed), Math.Min(OfArcs(sequence, profile.AccelerationCounts), OfJoints(sequence, profile)));
            while (headroom > 1.0 && Corners(sequence, profile, headroom) > Corners(sequence, profile, 1.0)) headroom -= Step;
        }

        return Math.Max(1.0, Math.Floor((headroom / Step) + 1e-6) * Step);
    }

    /// <summary>Across an arc the acceleration is the square of the speed divided by the radius.</summary>
    private static double OfArcs(VectorSequence sequence, double acceleration) => sequence.Segments
        .Where(segment => segment.Kind == VectorSegmentKind.Arc)
        .Select(segment => Math.Sqrt(acceleration * segment.Radius) / sequence.Speed)
        .DefaultIfEmpty(double.PositiveInfinity)
        .Min();

    /// <summary>At a joint the velocity changes by 2 v sin(turn / 2) (galil-dmc.md B.5). The change must not become larger than the plan allows at the sharpest
    /// turn that it runs without a stop, at the planned speed.</summary>
    private static double OfJoints(VectorSequence sequence, MachineProfile profile)
    {
        var sharpest = 0.0;
        var (start, before) = (sequence.Start, default((double X, double Y, double Z)?));
        foreach (var segment in sequence.Segments)
        {
            var (first, last) = Directions(start, segment, profile.Scale.Finer);
            if (before is { } direction) sharpest = Math.Max(sharpest, HalfTurnSine(direction, first));
            (before, start) = (last, segment.End);
        }

        return sharpest == 0.0 ? double.PositiveInfinity : Angle.FromDegrees(profile.SharpCornerDegrees / 2.0).Sin() / sharpest;
    }

    /// <summary>Directions of length 1 in which a segment begins and ends, in counts; a line may rise or fall.</summary>
    private static ((double X, double Y, double Z) First, (double X, double Y, double Z) Last) Directions(CountsPoint start, in VectorSegment segment, AxisScale scale)
    {
        if (segment.Kind == VectorSegmentKind.Arc && Move(new SegmentPath(start, segment), segment, scale) is var arc)
            return ((arc.StartTangent.X, arc.StartTangent.Y, 0.0), (arc.EndTangent.X, arc.EndTangent.Y, 0.0));
        var (x, y, z) = ((double)segment.End.X - start.X, (double)segment.End.Y - start.Y, (double)segment.End.Z - start.Z);
        var length = Math.Max(1.0, double.Hypot(double.Hypot(x, y), z));
        return ((x / length, y / length, z / length), (x / length, y / length, z / length));
    }

    /// <summary>Sine of half the angle between two directions: half the length of their difference.</summary>
    private static double HalfTurnSine((double X, double Y, double Z) one, (double X, double Y, double Z) other) => double.Hypot(double.Hypot(one.X - other.X, one.Y - other.Y), one.Z - other.Z) / 2.0;

    /// <summary>Number of places at which the path turns too sharply to be run without a stop at this factor of its speed.</summary>
    private static int Corners(VectorSequence sequence, MachineProfile profile, double factor)
    {
        var detector = new CornerDetector(profile, sequence.Speed * factor);
        var (corners, start) = (0, sequence.Start);
        foreach (var segment in sequence.Segments)
        {
            var course = new SegmentPath(start, segment);
            var move = Move(course, segment, profile.Scale.Finer);
            if (detector.IsCornerBefore(move)) corners++;
            detector.Cut(move);
            start = segment.End;
        }

        return corners;
    }

    private static Segment Move(SegmentPath course, VectorSegment segment, AxisScale scale)
    {
        Point2D InMillimetres(Point2D counts) => new(scale.ToMillimetres(counts.X), scale.ToMillimetres(counts.Y));
        var start = InMillimetres(course.At(0.0));
        if (segment.Kind == VectorSegmentKind.Line) return Segment.FromLine(start, InMillimetres(course.At(segment.Length)));
        var (theta, radius) = (Angle.FromDegrees(segment.ThetaDegrees), scale.LengthOf(segment.Radius));
        return Segment.FromArc(new ArcSegment(start - Vector2D.FromPolar(radius, theta), radius, theta, Angle.FromDegrees(segment.DeltaDegrees)));
    }
}
