using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>A line of items at their places from the left side of the frame, before it is aligned.</summary>
internal sealed class SetLine
{
    private readonly IReadOnlyList<PlacedItem> _items;

    /// <param name="height">Of letters at this place; for a line without items.</param>
    public SetLine(ParagraphMeasures paragraph, IReadOnlyList<PlacedItem> items, double left, double height, bool isFirst, SetLineEnd end)
    {
        (Paragraph, _items, IsFirst, End) = (paragraph, items, isFirst, end);
        Left = ContentLeft = ContentRight = left;
        Height = items.Count == 0 ? height : items.Max(item => item.Item.Format.Height);
        Ascent = Height;
        for (var i = 0; i < items.Count; i++)
        {
            var (item, x) = items[i];
            if (!item.HasInk) continue;
            if (i == 0) ContentLeft = x + item.Ink.Left;
            ContentRight = HasInk ? Math.Max(ContentRight, x + item.Ink.Right) : x + item.Ink.Right;
            HasInk = true;
            Ascent = Math.Max(Ascent, item.Ink.Top + ShiftOf(item));
            Depth = Math.Max(Depth, -item.Ink.Bottom - ShiftOf(item));
        }
    }

    public ParagraphMeasures Paragraph { get; }

    public IReadOnlyList<PlacedItem> Items => _items;

    /// <summary>The first line of its paragraph.</summary>
    public bool IsFirst { get; }

    public SetLineEnd End { get; }

    /// <summary>Where the pen began.</summary>
    public double Left { get; }

    public bool HasInk { get; }

    /// <summary>Left side of the first letter, or of the blanks before it.</summary>
    public double ContentLeft { get; }

    /// <summary>Right side of the last letter.</summary>
    public double ContentRight { get; }

    /// <summary>Of the highest capital letters.</summary>
    public double Height { get; }

    /// <summary>Of the highest curve above the baseline, at least <see cref="Height"/>.</summary>
    public double Ascent { get; }

    /// <summary>Of the lowest curve below the baseline, at least 0.</summary>
    public double Depth { get; }

    /// <summary>From the baseline of the line up to that of an item: its place in the height of the line (\A).</summary>
    public double ShiftOf(LineItem item) => item.Format.Alignment switch
    {
        LineAlignment.Top => Height - item.Body,
        LineAlignment.Centre => (Height - item.Body) / 2.0,
        _ => 0.0,
    };
}
