using System.Globalization;
using Engraver.Core.Sequencing;

namespace Engraver.Cli.Output;

/// <summary>How sequencing is told.</summary>
internal static class SequenceReport
{
    public static SequenceJson Json(SequencingResult result, SequenceJson.SecondsJson seconds) => new(
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
            stroke.Index, stroke.Closed, stroke.Segments, stroke.Length, stroke.Start.X, stroke.Start.Y, stroke.End.X, stroke.End.Y, stroke.Inside))],
        [.. result.Discontinuities.Select(end => new SequenceJson.DiscontinuityJson(
            end.Place.X, end.Place.Y, end.Gap, end.NearestHandle, end.DiagnosticId))],
        seconds);

    public static void Text(TextWriter output, SequencingResult result)
    {
        output.WriteLine(Invariant($"{result.Contours} contours ({result.Closed} closed, {result.Open} open) of {result.Segments} segments, {result.PathLength:0.###} mm to cut"));
        output.WriteLine(Invariant($"{result.Reversed} segments turned round, {result.DuplicatesRemoved} duplicates left out"));
        output.WriteLine(Invariant($"travel {result.Travel:0.###} mm ({result.TravelAsDrawn:0.###} mm as drawn), {result.TravelAndBack:0.###} mm with the way back"));
        foreach (var stroke in result.Strokes)
        {
            var inside = stroke.Inside < 0 ? "" : Invariant($", inside {stroke.Inside + 1}");
            output.WriteLine(Invariant(
                $"{stroke.Index + 1,5}  {(stroke.Closed ? "closed" : "open  ")} {stroke.Segments,5} segments {stroke.Length,10:0.###} mm  from {stroke.Start.X:0.####},{stroke.Start.Y:0.####} to {stroke.End.X:0.####},{stroke.End.Y:0.####}{inside}"));
        }

        if (result.Discontinuities.Count > 0) output.WriteLine(Invariant($"{result.Discontinuities.Count} open ends:"));
        foreach (var end in result.Discontinuities)
        {
            output.WriteLine(Invariant($"       {end.Place.X:0.####},{end.Place.Y:0.####}  nearest open end {(end.Gap is { } gap ? Invariant($"{gap:0.####} mm away") : "none")}"));
        }
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
