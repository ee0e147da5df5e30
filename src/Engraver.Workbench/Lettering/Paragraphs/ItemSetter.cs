using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Fonts;
using Engraver.Shaping;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Sets the pieces of a paragraph as letters, stacks and blanks, each in its own plane.</summary>
/// <param name="height">Of the entity; positive.</param>
internal sealed class ItemSetter(TextStyle style, double height, LetterFonts fonts, LayoutNotes notes)
{
    private const char NoBreakBlank = '\u00A0';
    private static readonly char[] s_blanks = [' ', NoBreakBlank];

    private readonly Dictionary<MTextFormat, SetFormat> _formats = [];
    private readonly Dictionary<GlyphCurves, InkBox> _inks = new(ReferenceEqualityComparer.Instance);

    public double HeightOf(MTextFormat format) => format.Height.Resolved(height);

    private SetFormat Of(MTextFormat format)
    {
        if (_formats.TryGetValue(format, out var known)) return known;
        var font = format.Font is { } named ? fonts.Of(named) : fonts.Of(style);
        var letters = new LetterFormat(HeightOf(format), format.Width.Resolved(Math.Abs(style.WidthFactor)), format.Oblique ?? style.Oblique, format.Tracking);
        var set = new SetFormat(font, letters, format.Marks, format.Alignment, LetterRun.Set(" ", font, letters, Point2D.Origin, notes).Advance);
        _formats.Add(format, set);
        return set;
    }

    public List<LineItem> ItemsOf(MTextParagraph paragraph)
    {
        var items = new List<LineItem>();
        foreach (var piece in paragraph.Pieces)
        {
            var format = Of(piece.Format);
            switch (piece.Kind)
            {
                case MTextPieceKind.Text:
                    Text(piece.Text, format, items);
                    break;
                case MTextPieceKind.Stack:
                    items.Add(StackOf(piece.Stack!, format));
                    break;
                case MTextPieceKind.Tab:
                    items.Add(new LineItem(LineItemKind.Tab, format, 0.0, format.Height));
                    break;
                case MTextPieceKind.DimensionLineBreak:
                    items.Add(new LineItem(LineItemKind.LineBreak, format, 0.0, format.Height));
                    break;
                default:
                    items.Add(new LineItem(LineItemKind.ColumnBreak, format, 0.0, format.Height));
                    break;
            }
        }

        return items;
    }

    private void Text(string text, SetFormat format, List<LineItem> items)
    {
        for (var at = 0; at < text.Length;)
        {
            var blank = text.IndexOfAny(s_blanks, at);
            if (blank == at)
            {
                items.Add(new LineItem(text[at] == NoBreakBlank ? LineItemKind.FixedBlank : LineItemKind.Blank, format, format.Blank, format.Height));
                at++;
                continue;
            }

            var end = blank < 0 ? text.Length : blank;
            var word = text[at..end];
            var (glyphs, advance, ink) = Letters(word, format);
            items.Add(new LineItem(LineItemKind.Letters, format, advance, format.Height) { Text = word, HasRightToLeft = ComplexLine.IsComplex(word) && ComplexLine.HasRightToLeft(word), Glyphs = glyphs, Ink = ink });
            at = end;
        }
    }

    private (IReadOnlyList<GlyphPlace> Glyphs, double Advance, InkBox Ink) Letters(string text, SetFormat format)
    {
        var run = LetterRun.Set(text, format.Font, format.Letters, Point2D.Origin, notes);
        var ink = InkBox.None;
        foreach (var glyph in run.Glyphs)
        {
            if (InkOf(glyph.Curves) is { IsEmpty: false } box) ink = ink.With(box.Placed(glyph.Map.XAxis.X, glyph.Map.YAxis.Y, glyph.Map.Origin.X, glyph.Map.Origin.Y));
        }

        return (run.Glyphs, run.Advance, ink);
    }

    private InkBox InkOf(GlyphCurves curves)
    {
        if (!_inks.TryGetValue(curves, out var ink)) _inks[curves] = ink = InkBox.Of(curves);
        return ink;
    }

    private LineItem StackOf(MTextStack stack, SetFormat format)
    {
        var (upper, lower) = (stack.Upper.Replace(NoBreakBlank, ' '), stack.Lower.Replace(NoBreakBlank, ' '));
        var (upperGlyphs, upperAdvance, upperInk) = Letters(upper, format);
        var (lowerGlyphs, lowerAdvance, lowerInk) = Letters(lower, format);
        var shape = new StackShape(stack.Kind, format.Height, upperAdvance, lowerAdvance);
        var ink = upperInk.Placed(1.0, 1.0, shape.UpperLeft, shape.UpperBaseline).With(lowerInk.Placed(1.0, 1.0, shape.LowerLeft, 0.0));
        foreach (var bar in shape.Bars) ink = ink.With(new InkBox(bar.From.X, bar.From.Y, bar.To.X, bar.To.Y));
        return new LineItem(LineItemKind.Stack, format, shape.Advance, shape.Height)
        {
            Glyphs = [.. upperGlyphs.Select(glyph => glyph.MovedBy(shape.UpperLeft, shape.UpperBaseline)), .. lowerGlyphs.Select(glyph => glyph.MovedBy(shape.LowerLeft, 0.0))],
            Rules = shape.Bars,
            Ink = ink,
        };
    }
}
