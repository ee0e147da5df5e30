using System.Globalization;
using Engraver.Core.Sequencing;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of sequencing.</summary>
public static class SequenceText
{
    public static void Write(TextWriter output, SequencingResult result)
    {
        output.WriteLine(Wording.Get("SequenceText.Contours", CountText.Format(result.Contours, "Contour"), result.Closed, result.Open, CountText.Format(result.Segments, "Segment"), result.PathLength));
        output.WriteLine(Wording.Get("SequenceText.Changes", CountText.Format(result.Reversed, "Segment"), CountText.Format(result.DuplicatesRemoved, "Duplicate")));
        output.WriteLine(Wording.Get("SequenceText.Travel", result.Travel, result.TravelAsDrawn, result.TravelAndBack));
        foreach (var stroke in result.Strokes)
        {
            var inside = stroke.Inside < 0 ? "" : Wording.Get("SequenceText.Inside", stroke.Inside + 1);
            output.WriteLine(Wording.Get(stroke.Segments == 1 ? "SequenceText.StrokeOfOneSegment" : "SequenceText.Stroke", stroke.Index + 1, stroke.Closed ? Wording.Get("SequenceText.Closed") : Wording.Get("SequenceText.Open"), stroke.Segments, stroke.Length, stroke.Start.X, stroke.Start.Y, stroke.End.X, stroke.End.Y, inside));
        }

        if (result.Discontinuities.Count > 0) WriteOpenEnds(output, result);
    }

    /// <summary>Every end of an open stroke with the gap to the nearest other one, mm.</summary>
    public static void WriteOpenEnds(TextWriter output, SequencingResult result)
    {
        output.WriteLine($"{CountText.Format(result.Discontinuities.Count, "OpenEnd")}:");
        foreach (var end in result.Discontinuities)
        {
            output.WriteLine(Wording.Get("SequenceText.NearestOpenEnd", end.Place.X, end.Place.Y, end.Gap is { } gap ? Wording.Get("SequenceText.MmAway", gap) : Wording.Get("SequenceText.None")));
        }
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
