using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Compares polled positions with the planned path while a sequence runs: a corrupted command moves the machine beside it.</summary>
/// <remarks>
/// A polled position is a reference (_RP), so no servo lag is in it; but the two axes are read one after the other, and a sample of the motion may be
/// between the two readings (galil-dmc.md C: 1 ms at TM 1000). So a correct point may appear beside the path by up to speed x sample x |sin x cos| of the
/// path's direction, at a joint by half of speed x sample. A larger distance is a fault at the first poll. A distance within these limits is a fault in
/// <see cref="MaxConsecutive"/> polls in a row, because a sample is between the two readings only now and then.
/// </remarks>
/// <param name="start">Where the first segment begins, job frame.</param>
/// <param name="segments">In the order of cutting.</param>
/// <param name="speed">VS, counts/s.</param>
/// <param name="followsHeight">An axis drives the tool: heights are compared too.</param>
/// <param name="sampleSeconds">Sample time of the controller's motion.</param>
internal sealed class PathWatch(CountsPoint start, IReadOnlyList<VectorSegment> segments, int speed, double sampleSeconds, bool followsHeight = false)
{
    /// <summary>Largest distance of a correct point from the planned path, counts: the position is rounded in both axes, and so is the assumed start of an
    /// arc.</summary>
    public const double Allowance = 2.0;

    /// <summary>Number of polls in a row with a distance that two readings at different times could explain, which together are a fault.</summary>
    private const int MaxConsecutive = 8;

    /// <summary>The counter may be older than the position by this, seconds.</summary>
    private const double LongestReply = 0.01;

    private int _inARow;

    /// <param name="executed">Segments that were complete when the position was read.</param>
    /// <param name="place">Position, job frame.</param>
    /// <returns>Why the job ends; null where the machine is on its path.</returns>
    public JobEnd? Check(int executed, CountsPoint place)
    {
        var (off, explained) = Nearest(Math.Clamp(executed, 0, segments.Count - 1), place);
        if (off <= Allowance) _inARow = 0;
        else if (off > Allowance + explained || ++_inARow >= MaxConsecutive) return Left(off, place, segments[Math.Clamp(executed, 0, segments.Count - 1)].EntityIndex);
        return null;
    }

    /// <summary>Compares the position at rest after the last segment.</summary>
    public JobEnd? LookAtEnd(CountsPoint place) => LookAtEnd(segments.Count, place);

    /// <param name="executed">Segments after which the machine is at rest, at least 1.</param>
    public JobEnd? LookAtEnd(int executed, CountsPoint place)
    {
        var last = segments[executed - 1];
        var off = double.Hypot(new Point2D(place.X, place.Y).DistanceTo(new Point2D(last.End.X, last.End.Y)), followsHeight ? (double)place.Z - last.End.Z : 0.0);
        return off <= Allowance ? null : Left(off, place, last.EntityIndex);
    }

    private static JobEnd Left(double off, CountsPoint place, int entity) => JobEnd.Deviated(Wording.Get("PathWatch.OffPath", place.X, place.Y, off, entity));

    /// <summary>Distance to the path near where the machine should be, and the part of it that two readings at different times explain.</summary>
    private (double Off, double Explained) Nearest(int at, CountsPoint counts)
    {
        var place = new Point2D(counts.X, counts.Y);
        var (off, explained) = (double.PositiveInfinity, 0.0);
        var ahead = -2.0 * speed * LongestReply;
        for (var i = Math.Max(0, at - 1); i < segments.Count && ahead <= 0.0; i++)
        {
            var segment = segments[i];
            var from = i == 0 ? start : segments[i - 1].End;
            var piece = Piece(new Point2D(from.X, from.Y), segment);
            var distance = !followsHeight ? piece.DistanceTo(place) : from.Z == segment.End.Z ? double.Hypot(piece.DistanceTo(place), counts.Z - from.Z) : DistanceInSpace(from, segment.End, counts);
            if (distance < off) (off, explained) = (distance, Explained(piece, place) + RiseInASample(from, segment.End));
            if (i >= at) ahead += segment.Length;
        }

        return (off, explained);
    }

    /// <summary>Distance from a line that rises or falls, or is vertical.</summary>
    private static double DistanceInSpace(CountsPoint from, CountsPoint to, CountsPoint place)
    {
        var (way, spoke) = (to - from, place - from);
        var length = LengthOf(way);
        var fraction = Math.Clamp((((double)way.X * spoke.X) + ((double)way.Y * spoke.Y) + ((double)way.Z * spoke.Z)) / (length * length), 0.0, 1.0);
        return double.Hypot(double.Hypot(spoke.X - (fraction * way.X), spoke.Y - (fraction * way.Y)), spoke.Z - (fraction * way.Z));
    }

    /// <summary>How far a line rises in the distance of one sample: by this much the height may have been read too late.</summary>
    private double RiseInASample(CountsPoint from, CountsPoint to) => from.Z == to.Z ? 0.0 : speed * sampleSeconds * Math.Abs((double)to.Z - from.Z) / LengthOf(to - from);

    private static double LengthOf(CountsPoint way) => double.Hypot(double.Hypot(way.X, way.Y), way.Z);

    private static Segment Piece(Point2D from, in VectorSegment segment)
    {
        if (segment.Kind == VectorSegmentKind.Line) return Segment.FromLine(from, new Point2D(segment.End.X, segment.End.Y));
        var theta = Angle.FromDegrees(segment.ThetaDegrees);
        return Segment.FromArc(new ArcSegment(from - Vector2D.FromPolar(segment.Radius, theta), segment.Radius, theta, Angle.FromDegrees(segment.DeltaDegrees)));
    }

    private double Explained(Segment piece, Point2D place)
    {
        var step = speed * sampleSeconds;
        var (begin, end) = (piece.PointAt(0.0), piece.PointAt(1.0));
        if (Math.Min(begin.DistanceTo(place), end.DistanceTo(place)) <= 2.0 * step) return step / 2.0;
        var direction = piece.Kind == SegmentKind.Line ? end - begin : place - piece.Arc.Centre;
        var length = direction.Length;
        return length == 0.0 ? step / 2.0 : step * Math.Abs(direction.X * direction.Y) / (length * length);
    }
}
