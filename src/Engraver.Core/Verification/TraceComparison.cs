using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The judge of a run: compares where the machine says it was with the drawing, both ways, and never with our own plan.</summary>
public static class TraceComparison
{
    /// <summary>Largest distance of a cutting sample from the drawing, and the length of the drawing that no cut came near.</summary>
    /// <param name="drawing">What was to be cut, millimetres; order and direction do not matter. Ellipses and splines are exact here, not the arcs that were cut for them.</param>
    /// <param name="trace">In order of time.</param>
    /// <param name="tolerances">What counts as cut, and how finely the drawing is walked.</param>
    public static TraceVerdict Compare(IReadOnlyList<Segment> drawing, IReadOnlyList<TraceSample> trace, TraceTolerances tolerances)
    {
        var pieces = CurvePieces.Of(drawing);
        var cut = MeasureCut(new SegmentIndex(pieces), trace, tolerances.Coverage);
        var (missing, missingAt) = MeasureMissing(pieces, new TraceIndex(trace), tolerances);
        return cut with { MissingLength = missing, MissingAt = missingAt };
    }

    private static TraceVerdict MeasureCut(SegmentIndex drawing, IReadOnlyList<TraceSample> trace, double coverage)
    {
        var (samples, largest, extra) = (0, 0.0, 0.0);
        TraceSample? worst = null;
        var wasOff = false;
        for (var i = 0; i < trace.Count; i++)
        {
            var sample = trace[i];
            if (!sample.Cutting) continue;
            samples++;
            var deviation = drawing.DistanceFrom(sample.Place);
            if (worst is null || deviation > largest) (largest, worst) = (deviation, sample);
            var isOff = deviation > coverage;
            if (i > 0 && trace[i - 1].Cutting && (isOff || wasOff)) extra += trace[i - 1].Place.DistanceTo(sample.Place);
            wasOff = isOff;
        }

        return new TraceVerdict(samples, largest, worst, 0.0, null, extra);
    }

    private static (double Length, Point2D? At) MeasureMissing(IReadOnlyList<Segment> drawing, TraceIndex trace, TraceTolerances tolerances)
    {
        var missing = 0.0;
        Point2D? first = null;
        foreach (var segment in drawing)
        {
            var steps = tolerances.StepsFor(segment.Length);
            for (var step = 0; step < steps; step++)
            {
                var place = segment.PointAt((step + 0.5) / steps); // the middle of a step speaks for all of it
                if (trace.PassedNear(place, tolerances.Coverage)) continue;
                missing += CurvePieces.StepLength(segment, step, steps);
                first ??= place;
            }
        }

        return (missing, first);
    }
}
