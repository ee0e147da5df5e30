namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Breaks a paragraph into lines: at blanks and tabs, before the first word whose letters pass the right side. A word that is longer than the line
/// remains whole, and so do words with hyphens. The blanks before a break are dropped; those at the start of the paragraph are kept, and a word that does
/// not fit after them begins a line.</summary>
internal static class LineBreaker
{
    /// <summary>A word may pass the right side by this, as a multiple of the height: widths in files are rounded.</summary>
    private const double Tolerance = 1e-6;

    /// <param name="width">Of the frame; infinite for a text that does not wrap.</param>
    /// <param name="height">Of letters in a paragraph without any.</param>
    public static IEnumerable<SetLine> LinesOf(IReadOnlyList<LineItem> items, ParagraphMeasures paragraph, double width, double height)
    {
        var builder = new LineBuilder(paragraph);
        var right = width - paragraph.Right + (Tolerance * paragraph.Unit);
        builder.Start(isFirst: true);
        for (var at = 0; at < items.Count;)
        {
            var item = items[at];
            if (item.Kind is LineItemKind.LineBreak or LineItemKind.ColumnBreak)
            {
                yield return builder.Finish(item.Kind == LineItemKind.LineBreak ? SetLineEnd.LineBreak : SetLineEnd.ColumnBreak, item.Format.Height);
                builder.Start(isFirst: false);
                height = item.Format.Height;
                at++;
                continue;
            }

            if (item.IsGap)
            {
                builder.Add(item);
                at++;
                continue;
            }

            var (end, inked) = WordAt(items, at);
            if (builder.HasItems && builder.EndWith(inked) > right)
            {
                yield return builder.Finish(SetLineEnd.Wrapped, item.Format.Height);
                builder.Start(isFirst: false);
            }

            for (; at < end; at++) builder.Add(items[at]);
        }

        yield return builder.Finish(SetLineEnd.Paragraph, height);
    }

    /// <summary>The index after a word, and its length up to the right side of its last letter.</summary>
    private static (int End, double Inked) WordAt(IReadOnlyList<LineItem> items, int first)
    {
        var (at, length, inked) = (first, 0.0, 0.0);
        for (; at < items.Count && items[at] is { IsGap: false, Kind: not (LineItemKind.LineBreak or LineItemKind.ColumnBreak) } item; at++)
        {
            if (item.HasInk) inked = Math.Max(inked, length + item.Ink.Right);
            length += item.Advance;
        }

        return (at, inked);
    }
}
