using System.Globalization;
using Engraver.Core.Sequencing;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Reports;

/// <summary>How sequencing is told to people.</summary>
public static class SequenceText
{
    public static void Write(TextWriter output, SequencingResult result)
    {
        output.WriteLine(Invariant($"{CountText.Format(result.Contours, "contour")} ({result.Closed} closed, {result.Open} open) of {CountText.Format(result.Segments, "segment")}, {result.PathLength:0.###} mm to cut"));
        output.WriteLine(Invariant($"{CountText.Format(result.Reversed, "segment")} turned round, {CountText.Format(result.DuplicatesRemoved, "duplicate")} left out"));
        output.WriteLine(Invariant($"travel {result.Travel:0.###} mm ({result.TravelAsDrawn:0.###} mm as drawn), {result.TravelAndBack:0.###} mm with the way back"));
        foreach (var stroke in result.Strokes)
        {
            var inside = stroke.Inside < 0 ? "" : Invariant($", inside {stroke.Inside + 1}");
            output.WriteLine(Invariant(
                $"{stroke.Index + 1,5}  {(stroke.Closed ? "closed" : "open  ")} {stroke.Segments,5} segments {stroke.Length,10:0.###} mm  from {stroke.Start.X:0.####},{stroke.Start.Y:0.####} to {stroke.End.X:0.####},{stroke.End.Y:0.####}{inside}"));
        }

        if (result.Discontinuities.Count > 0) WriteOpenEnds(output, result);
    }

    /// <summary>Every end of an open stroke with the gap to the nearest other one, mm.</summary>
    public static void WriteOpenEnds(TextWriter output, SequencingResult result)
    {
        output.WriteLine($"{CountText.Format(result.Discontinuities.Count, "open end")}:");
        foreach (var end in result.Discontinuities)
        {
            output.WriteLine(Invariant($"       {end.Place.X:0.####},{end.Place.Y:0.####}  nearest open end {(end.Gap is { } gap ? Invariant($"{gap:0.####} mm away") : "none")}"));
        }
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
