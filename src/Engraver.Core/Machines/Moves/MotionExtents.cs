namespace Engraver.Core.Machines.Moves;

/// <summary>The range of counts in which a motion program moves the axes, job frame. In plan: strokes with the bulge of their arcs, and the rapids to the first
/// stroke, between strokes and to the finish.</summary>
/// <param name="Cuts">The heights of its strokes; null for a program without strokes.</param>
public readonly record struct MotionExtents(long MinX, long MinY, long MaxX, long MaxY, CountsRange? Cuts = null)
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
                extents = extents.At(from.Z);
                foreach (var segment in sequence.Segments)
                {
                    extents = extents.With(from, segment);
                    from = segment.End;
                }
            }
        }

        return extents;
    }

    /// <summary>What both reach.</summary>
    public MotionExtents Union(MotionExtents other) => new(Math.Min(MinX, other.MinX), Math.Min(MinY, other.MinY), Math.Max(MaxX, other.MaxX), Math.Max(MaxY, other.MaxY), other.Cuts is { } cuts ? Cuts?.With(cuts.Min).With(cuts.Max) ?? cuts : Cuts);

    /// <summary>The heights that the tool's axis reaches, above the drawing's height 0: from the deepest cut to the clearance height of the rapids; in a dry
    /// run raised by <see cref="DryRunLift"/>.</summary>
    /// <returns>Null where no axis is the tool drive, or nothing is cut: the height does not change.</returns>
    public CountsRange? Heights(MachineProfile profile, bool dryRun)
    {
        ArgumentNullException.ThrowIfNull(profile);
        if (profile.Height is null || Cuts is not { } cuts) return null;
        var lift = dryRun ? DryRunLift.Of(profile, this) : 0;
        var reached = cuts.With(profile.ClearanceCounts);
        return new CountsRange(reached.Min + lift, reached.Max + lift);
    }

    private static MotionExtents At(CountsPoint point) => new(point.X, point.Y, point.X, point.Y);

    private MotionExtents At(int height) => this with { Cuts = Cuts?.With(height) ?? new CountsRange(height, height) };

    private MotionExtents With(double x, double y) => this with
    {
        MinX = Math.Min(MinX, (long)Math.Floor(x)),
        MinY = Math.Min(MinY, (long)Math.Floor(y)),
        MaxX = Math.Max(MaxX, (long)Math.Ceiling(x)),
        MaxY = Math.Max(MaxY, (long)Math.Ceiling(y)),
    };

    private MotionExtents With(CountsPoint from, in VectorSegment segment)
    {
        var extents = With(segment.End.X, segment.End.Y).At(segment.End.Z);
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

/// <summary>A range of counts of one axis; both ends are reached.</summary>
public readonly record struct CountsRange(long Min, long Max)
{
    public CountsRange With(long counts) => new(Math.Min(Min, counts), Math.Max(Max, counts));
}
