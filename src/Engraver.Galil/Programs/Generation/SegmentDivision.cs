using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Divides a segment where its speed changes.</summary>
internal static class SegmentDivision
{
    /// <summary>Neither part is shorter, counts.</summary>
    private const double ShortestLine = 1.0;
    private const double ShortestArc = 2.0;

    /// <summary>The place may be this much later, counts, where whole counts are nearer to the line.</summary>
    private const double Search = 1.5;
    private const double SearchStep = 0.5;

    /// <summary>Number of steps of the angle among which the place on an arc is chosen.</summary>
    private const int AngleSteps = 24;

    /// <summary>Divides a line at whole counts.</summary>
    /// <param name="from">Its start.</param>
    /// <param name="z">Height at its start.</param>
    /// <param name="braking">Wanted length of the last part.</param>
    /// <returns>Null where there is no such place.</returns>
    public static (VectorSegment First, VectorSegment Last)? Line(Point2D from, int z, in VectorSegment line, double braking)
    {
        var end = new Point2D(line.End.X, line.End.Y);
        var (way, rise) = (end - from, (double)line.End.Z - z);
        var (best, off) = (default((CountsPoint Place, double First, double Last)?), double.PositiveInfinity);
        for (var later = 0.0; later <= Search; later += SearchStep)
        {
            var part = (line.Length - braking + later) / line.Length;
            var place = CountsScale.Round(from + (way * part)) with { Z = z + (int)Math.Round(rise * part) };
            var exact = new Point2D(place.X, place.Y);
            var (first, last) = (double.Hypot(from.DistanceTo(exact), (double)place.Z - z), double.Hypot(exact.DistanceTo(end), (double)line.End.Z - place.Z));
            if (first < ShortestLine || last < ShortestLine || last > braking + SearchStep) continue;
            var away = way.Length == 0.0 ? 0.0 : Math.Abs(way.Cross(exact - from)) / way.Length;
            if (away < off - 0.05) (best, off) = ((place, first, last), away);
        }

        return best is { } found ? (line with { End = found.Place, Length = found.First }, line with { Length = found.Last }) : null;
    }

    /// <summary>Divides an arc so that both parts are on its circle to the resolution of the controller's angles.</summary>
    /// <param name="from">Its exact start.</param>
    /// <param name="braking">Wanted length of the last part.</param>
    /// <param name="quantum">Resolution of angles.</param>
    /// <returns>Null where one part would be too short.</returns>
    public static (VectorSegment First, VectorSegment Last)? Arc(Point2D from, in VectorSegment arc, double braking, AngleQuantum quantum)
    {
        var wanted = arc.DeltaDegrees * (arc.Length - braking) / arc.Length;
        var (best, off) = (0.0, double.PositiveInfinity);
        for (var step = 0; step < AngleSteps; step++)
        {
            var delta = quantum.Quantize(wanted + (Math.Sign(wanted) * step * quantum.Degrees));
            var away = Math.Abs(quantum.QuantizeDirection(arc.ThetaDegrees + delta) - Angle.FromDegrees(arc.ThetaDegrees + delta).Positive().Degrees) + Math.Abs(quantum.Quantize(arc.DeltaDegrees - delta) - (arc.DeltaDegrees - delta));
            if (away < off) (best, off) = (delta, away);
        }

        var first = new ArcPrediction(from, arc.Radius, arc.ThetaDegrees, best);
        var last = new ArcPrediction(first.End, arc.Radius, quantum.QuantizeDirection(arc.ThetaDegrees + best), quantum.Quantize(arc.DeltaDegrees - best));
        if (best * arc.DeltaDegrees <= 0.0 || first.Length < ShortestArc || last.Length < ShortestArc) return null;
        return (
            arc with { End = CountsScale.Round(first.End) with { Z = arc.End.Z }, DeltaDegrees = best, Length = first.Length },
            arc with { ThetaDegrees = last.ThetaDegrees, DeltaDegrees = last.DeltaDegrees, Length = last.Length });
    }
}
