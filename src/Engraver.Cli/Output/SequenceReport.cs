using Engraver.Core.Operations;
using Engraver.Core.Sequencing;

namespace Engraver.Cli.Output;

/// <summary>Reports sequencing as JSON.</summary>
internal static class SequenceReport
{
    public static SequenceJson Json(SequencingResult result, IReadOnlyList<StrokePass> passes, SequenceJson.SecondsJson seconds)
    {
        StrokePass? PassOf(SequencedStroke stroke) => passes.Count == 0 ? null : passes[stroke.Index];
        return new(
            result.Contours,
            result.Closed,
            result.Open,
            result.Segments,
            result.Reversed,
            result.DuplicatesRemoved,
            result.PathLength,
            result.Travel,
            result.TravelAndBack,
            result.TravelAsDrawn,
            [.. result.Strokes.Select(stroke => new SequenceJson.StrokeJson(
                stroke.Index, stroke.Closed, stroke.Segments, stroke.Length, stroke.Start.X, stroke.Start.Y, stroke.End.X, stroke.End.Y, stroke.Inside) { Operation = PassOf(stroke)?.Operation.Id, Pass = PassOf(stroke)?.Pass, Depth = PassOf(stroke)?.Depth })],
            [.. result.Discontinuities.Select(end => new SequenceJson.DiscontinuityJson(
                end.Place.X, end.Place.Y, end.Gap, end.NearestHandle, end.DiagnosticId))],
            seconds);
    }
}
