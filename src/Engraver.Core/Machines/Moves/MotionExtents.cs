namespace Engraver.Core.Machines.Moves;

/// <summary>The counts between which a motion program moves the axes of the plane, job frame: strokes with the bulge of their arcs, the way to the first of them, between them and to the finish.</summary>
public readonly record struct MotionExtents(long LeastX, long LeastY, long MostX, long MostY)
{
    public static MotionExtents Of(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        var extents = At(program.Start);
        if (program.Finish is { } finish) extents = extents.With(finish.X, finish.Y);
        foreach (var stroke in program.Strokes)
        {
            extents = extents.With(stroke.Start.X, stroke.Start.Y);
            foreach (var sequence in stroke.Sequences)
            {
                var from = sequence.Start;
                foreach (var segment in sequence.Segments)
                {
                    extents = extents.With(from, segment);
                    from = segment.End;
                }
            }
        }

        return extents;
    }

    private static MotionExtents At(CountsPoint point) => new(point.X, point.Y, point.X, point.Y);

    private MotionExtents With(double x, double y) => new(
        Math.Min(LeastX, (long)Math.Floor(x)), Math.Min(LeastY, (long)Math.Floor(y)), Math.Max(MostX, (long)Math.Ceiling(x)), Math.Max(MostY, (long)Math.Ceiling(y)));

    private MotionExtents With(CountsPoint from, in VectorSegment segment)
    {
        var extents = With(segment.End.X, segment.End.Y);
        if (segment.Kind == VectorSegmentKind.Line) return extents;
        var theta = segment.ThetaDegrees * Math.PI / 180.0;
        var (centreX, centreY) = (from.X - (segment.Radius * Math.Cos(theta)), from.Y - (segment.Radius * Math.Sin(theta)));
        var (first, last) = (segment.ThetaDegrees, segment.ThetaDegrees + segment.DeltaDegrees);
        for (var quarter = (long)Math.Ceiling(Math.Min(first, last) / 90.0); quarter * 90.0 <= Math.Max(first, last); quarter++)
        {
            var (x, y) = (((quarter % 4) + 4) % 4) switch { 0 => (1, 0), 1 => (0, 1), 2 => (-1, 0), _ => (0, -1) };
            extents = extents.With(Math.Round(centreX + (segment.Radius * x)), Math.Round(centreY + (segment.Radius * y)));
        }

        return extents;
    }
}
