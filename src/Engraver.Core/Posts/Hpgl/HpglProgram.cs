using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts.Hpgl;

/// <summary>Writes one program, one command per line, and measures the distance of the pen from the path caused by rounding.</summary>
internal sealed class HpglProgram(HpglSheet sheet, bool writesArcs)
{
    /// <summary>Fraction of a unit by which chords may differ from an arc.</summary>
    private const double ChordShare = 0.25;

    /// <summary>Part of a unit by which an arc with rounded start and centre may differ from the drawn arc; otherwise it becomes chords.</summary>
    private const double ArcShare = 0.7;

    /// <summary>The finest chord angle of a plotter, and the coarsest that is requested, degrees.</summary>
    private const double FinestChord = 0.5;
    private const double CoarsestChord = 15.0;

    private readonly StringBuilder _text = new();
    private UnitPlace _place;

    /// <summary>Largest distance of a place of the pen from the drawn line or arc, millimetres; for an arc including the height of its chords.</summary>
    public double LargestError { get; private set; }

    public Point2D ErrorAt { get; private set; }

    /// <param name="penOf">The pen of a stroke, by its index.</param>
    /// <param name="feedMmPerMinute">Of strokes that state none.</param>
    public string Write(Toolpath path, Func<int, int> penOf, double feedMmPerMinute)
    {
        ErrorAt = path.Strokes[0].Start;
        Line("IN");
        var (pen, feed) = (penOf(0), path.Strokes[0].FeedMmPerMinute ?? feedMmPerMinute);
        Append($"SP{pen}");
        if (sheet.PerMillimetre != HpglSheet.PlotterUnits)
        {
            Append($"IP0,0,{100 * HpglSheet.PlotterUnits},{100 * HpglSheet.PlotterUnits}"); // 100 mm along each axis
            Append($"SC0,{100 * sheet.PerMillimetre},0,{100 * sheet.PerMillimetre}");
        }

        Append($"VS{NumberText.Rounded(feed / 600.0, 4)}"); // cm/s
        for (var i = 0; i < path.Strokes.Count; i++)
        {
            var own = path.Strokes[i].FeedMmPerMinute ?? feedMmPerMinute;
            if (penOf(i) != pen) Append($"SP{pen = penOf(i)}");
            if (own != feed) Append($"VS{NumberText.Rounded((feed = own) / 600.0, 4)}");
            Stroke(path.Strokes[i]);
        }

        Line("SP0");
        return _text.ToString();
    }

    private void Stroke(ToolpathStroke stroke)
    {
        _place = sheet.Of(stroke.Start);
        Measure(stroke.Start);
        Append($"PU{_place.X},{_place.Y}");
        Line("PD");
        foreach (var segment in stroke.Moves.Select(move => move.Segment))
        {
            DrawTo(segment.Start); // within the join tolerance
            if (segment.Kind == SegmentKind.Line) DrawTo(segment.End);
            else if (writesArcs && Fits(segment)) Arc(segment);
            else Chords(segment);
        }

        Line("PU");
    }

    private void DrawTo(Point2D to)
    {
        Measure(to);
        if (sheet.Of(to) == _place) return;
        _place = sheet.Of(to);
        Append($"PD{_place.X},{_place.Y}");
    }

    private void Measure(Point2D drawn, double more = 0.0)
    {
        var error = sheet.Millimetres(sheet.Of(drawn)).DistanceTo(drawn) + more;
        if (error > LargestError) (LargestError, ErrorAt) = (error, drawn);
    }

    private void Chords(in Segment segment)
    {
        var arc = segment.Arc;
        var height = ChordShare * sheet.Unit;
        var turn = arc.Radius <= height ? Math.PI / 2.0 : 2.0 * Math.Acos(1.0 - (height / arc.Radius));
        var count = (int)Math.Ceiling(Math.Abs(arc.Sweep.Radians) / turn);
        for (var i = 1; i <= count; i++)
        {
            var to = i == count ? segment.End : arc.PointAt((double)i / count);
            Measure(to, arc.Radius * (1.0 - Math.Cos(arc.Sweep.Radians / count / 2.0)));
            DrawTo(to);
        }
    }

    /// <summary>True when the plotter's arc from rounded numbers stays near the drawn one: its points differ at most by the differences of the centres and
    /// radii.</summary>
    private bool Fits(in Segment segment)
    {
        var (centre, start) = (sheet.Millimetres(sheet.Of(segment.Arc.Centre)), sheet.Millimetres(sheet.Of(segment.Start)));
        var apart = centre.DistanceTo(segment.Arc.Centre) + Math.Abs(centre.DistanceTo(start) - segment.Arc.Radius);
        return sheet.Of(segment.Start) == _place && apart <= ArcShare * sheet.Unit && Height(segment.Arc, FinestChord) <= ChordShare * sheet.Unit;
    }

    private void Arc(in Segment segment)
    {
        var arc = segment.Arc;
        var (centre, chord) = (sheet.Of(arc.Centre), CoarsestChord);
        while (chord > FinestChord && Height(arc, chord) > ChordShare * sheet.Unit) chord = Math.Max(FinestChord, chord - FinestChord);
        var apart = sheet.Millimetres(centre).DistanceTo(arc.Centre) + Math.Abs(sheet.Millimetres(centre).DistanceTo(sheet.Millimetres(_place)) - arc.Radius) + Height(arc, chord);
        if (apart > LargestError) (LargestError, ErrorAt) = (apart, segment.Start);
        Append($"AA{centre.X},{centre.Y},{NumberText.Rounded(arc.Sweep.Degrees, 4)},{NumberText.Rounded(chord, 4)}");
        if (segment.Kind == SegmentKind.Circle) return;
        _place = sheet.Of(segment.End);
        Measure(segment.End);
        Append($"PD{_place.X},{_place.Y}"); // the plotter rounds the end of the arc: the exact end is written
    }

    private static double Height(ArcSegment arc, double chordDegrees) => arc.Radius * (1.0 - Math.Cos(chordDegrees * Math.PI / 360.0));

    private void Append(FormattableString text) => Line(FormattableString.Invariant(text));

    private void Line(string text) => _text.Append(text).Append(";\n");
}
