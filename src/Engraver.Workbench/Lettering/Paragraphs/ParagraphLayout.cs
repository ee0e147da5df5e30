using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>The layout of an MTEXT (DXF reference, "MTEXT"; docs/text-codes.md, "Layout of an MTEXT").</summary>
/// <remarks>Width factor and slant of the style apply. Its fixed height is used if the entity states none. Upside down and backwards, also a negative width
/// factor, apply to texts of one line only.</remarks>
public static class ParagraphLayout
{
    private const int TopToBottom = 3;
    private const int AsStyle = 5;

    /// <returns>Null if the text has no size.</returns>
    public static TextLayout? Of(PlacedText text, LetterFonts fonts)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(fonts);
        var written = text.Written.Paragraphs ?? new WrittenParagraphs();
        var style = fonts.StyleOf(text.Style);
        var height = text.Written.Height > 0.0 ? text.Written.Height : style.FixedHeight;
        if (!(height > 0.0) || style.WidthFactor == 0.0) return null;

        var (content, notes) = (MTextParser.Parse(text.Written.Raw), new LayoutNotes());
        notes.AddCodes(content.UnknownCodes);
        if (written.FlowDirection == TopToBottom || (written.FlowDirection == AsStyle && style.IsVertical)) notes.Add(LayoutNoteKind.FormIgnored, Wording.Get("LineLayout.Vertical"));
        if (written.Columns is { LinkedHandles.Count: > 0 }) notes.Add(LayoutNoteKind.FormIgnored, Wording.Get("ParagraphLayout.LinkedColumns"));

        var plan = ColumnPlan.Of(written);
        var lines = LinesOf(content, new ItemSetter(style, height, fonts, notes), plan.Width, height);
        var flow = LineFlow.Of(lines, plan, new LineSpacing(written, height));
        var width = plan.Width > 0.0 ? plan.Width : lines.Max(line => Math.Max(0.0, line.ContentRight + line.Paragraph.Right));

        var attachment = Math.Clamp(written.Attachment, 1, 9) - 1;
        var writer = new LineWriter((attachment % 3) switch { 0 => ParagraphAlignment.Left, 1 => ParagraphAlignment.Centre, _ => ParagraphAlignment.Right }, width, plan.Width > 0.0);
        var stated = plan.StatedHeight(flow.Columns);
        var left = -0.5 * (attachment % 3) * plan.TotalWidth(flow.Columns, width);
        var top = 0.5 * (attachment / 3) * (stated > 0.0 ? stated : flow.Height);
        foreach (var (line, column, baseline) in flow.Lines) writer.Write(line, left + plan.LeftOf(column, flow.Columns, width), top + baseline);
        return new TextLayout(ParagraphPlane.Of(text), writer.Glyphs, writer.Rules, notes.All);
    }

    private static List<SetLine> LinesOf(MTextContent content, ItemSetter setter, double wrap, double height)
    {
        var lines = new List<SetLine>();
        var measures = default(ParagraphMeasures);
        foreach (var paragraph in content.Paragraphs)
        {
            if (measures?.Format != paragraph.Format) measures = new ParagraphMeasures(paragraph.Format, height);
            var items = setter.ItemsOf(paragraph);
            lines.AddRange(LineBreaker.LinesOf(items, measures!, wrap > 0.0 ? wrap : double.PositiveInfinity, setter.HeightOf(paragraph.End)));
        }

        while (lines.Count > 1 && lines[^1].Items.Count == 0 && lines[^2].End == SetLineEnd.ColumnBreak) lines.RemoveAt(lines.Count - 1);
        return lines;
    }
}
