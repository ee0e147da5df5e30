using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Fonts.Finding;

namespace Engraver.Workbench.Lettering;

/// <summary>The layout of a text of one line: TEXT, ATTRIB and constant ATTDEF (DXF reference, "TEXT").</summary>
public static class LineLayout
{
    /// <summary>Heights of the lines drawn with letters, as parts of the height of capital letters.</summary>
    internal const double UnderlineAt = -0.2;
    internal const double OverlineAt = 1.2;
    internal const double StrikeThroughAt = 0.5;

    /// <returns>Null if the text has no size: height, width factor or the length between its two points is zero.</returns>
    public static TextLayout? Of(PlacedText text, LetterFonts fonts)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(fonts);
        var written = text.Written;
        var style = fonts.StyleOf(text.Style);
        var height = written.Height > 0.0 ? written.Height : style.FixedHeight;
        if (!(height > 0.0) || written.WidthFactor == 0.0) return null;
        var (font, notes) = (fonts.Of(style), new LayoutNotes());
        if (style.IsVertical) notes.Add(LayoutNoteKind.FormIgnored, Wording.Get("LineLayout.Vertical"));
        var line = TextCodes.Parse(written.Raw);
        notes.AddCodes(line.UnknownCodes);
        var form = new LetterFormat(height, Math.Abs(written.WidthFactor), written.Oblique, 1.0);
        var isBetween = written is { Horizontal: 3 or 5, Second: not null };
        var length = isBetween ? (written.Second!.Value - written.Insertion).Length : 0.0;
        if (isBetween)
        {
            var natural = Set(line, font, form, notes).Advance;
            if (!(natural > 0.0) || !(length > 0.0)) return null;
            form = written.Horizontal == 3 ? form with { Height = height * length / natural } : form with { WidthFactor = form.WidthFactor * length / natural };
        }

        var set = Set(line, font, form, notes);
        var turn = isBetween ? Angle.Direction(written.Second!.Value.X - written.Insertion.X, written.Second.Value.Y - written.Insertion.Y) : written.Rotation;
        var usesSecond = !isBetween && written.Second is not null && (written.Horizontal != 0 || written.Vertical != 0);
        var at = usesSecond ? written.Second!.Value : written.Insertion;
        var shift = isBetween ? default : ShiftOf(written, set, font, form);
        var generation = written.WidthFactor < 0.0 ? written.Generation ^ TextGeneration.Backwards : written.Generation;
        var plane = text.Inserts.After(written.OwnSystem).After(PlaneOf(at, turn, generation)).After(Placement.Identity.MovedBy(shift));
        return new TextLayout(plane, set.Glyphs, set.Rules, notes.All);
    }

    /// <summary>The characters and their lines, from the origin on.</summary>
    private static (List<GlyphPlace> Glyphs, List<LayoutRule> Rules, double Advance) Set(TextLine line, FoundFont font, LetterFormat form, LayoutNotes notes)
    {
        var (glyphs, rules, x) = (new List<GlyphPlace>(), new List<LayoutRule>(), 0.0);
        foreach (var run in line.Runs)
        {
            var set = LetterRun.Set(run.Text, font, form, new Point2D(x, 0.0), notes);
            glyphs.AddRange(set.Glyphs);
            AddRules(rules, run.Marks, form, x, x + set.Advance, baseline: 0.0);
            x += set.Advance;
        }

        return (glyphs, rules, x);
    }

    /// <summary>Adds the lines of a run of letters.</summary>
    internal static void AddRules(List<LayoutRule> rules, LineMarks marks, LetterFormat form, double from, double to, double baseline)
    {
        if (marks == LineMarks.None || from == to) return;
        if (marks.HasFlag(LineMarks.Underline)) Add(UnderlineAt);
        if (marks.HasFlag(LineMarks.Overline)) Add(OverlineAt);
        if (marks.HasFlag(LineMarks.StrikeThrough)) Add(StrikeThroughAt);

        void Add(double part)
        {
            var above = part * form.Height;
            var slant = LetterRun.SlantAt(form, above);
            rules.Add(new LayoutRule(new Point2D(from + slant, baseline + above), new Point2D(to + slant, baseline + above)));
        }
    }

    /// <summary>From the start of the baseline to the point of the alignment, reversed.</summary>
    private static Vector3D ShiftOf(WrittenText written, (List<GlyphPlace> Glyphs, List<LayoutRule> Rules, double Advance) set, FoundFont font, LetterFormat form)
    {
        var x = written.Horizontal switch { 1 or 4 => -0.5 * set.Advance, 2 => -set.Advance, _ => 0.0 };
        if (written.Horizontal == 4) return new Vector3D(x, -MiddleOf(set.Glyphs, form), 0.0);
        var y = written.Vertical switch
        {
            1 => font.Font.Metrics.Descent * form.Height / font.Font.Metrics.CapHeight,
            2 => -0.5 * form.Height,
            3 => -form.Height,
            _ => 0.0,
        };
        return new Vector3D(x, y, 0.0);
    }

    /// <summary>Middle of the letters as they are, from the lowest descender to the highest point; of a text without letters, of a capital letter.</summary>
    private static double MiddleOf(List<GlyphPlace> glyphs, LetterFormat form)
    {
        var box = glyphs.Aggregate(Bounds2D.Empty, (all, glyph) => all.Union(LetterCurves.BoundsOf(glyph)));
        return box.IsEmpty ? 0.5 * form.Height : 0.5 * (box.MinY + box.MaxY);
    }

    private static Placement PlaneOf(Vector3D at, Angle turn, TextGeneration generation)
    {
        var x = generation.HasFlag(TextGeneration.Backwards) ? -1.0 : 1.0;
        var y = generation.HasFlag(TextGeneration.UpsideDown) ? -1.0 : 1.0;
        return Placement.FromInsert(new Vector3D(x, y, 1.0), turn).MovedBy(at);
    }
}
