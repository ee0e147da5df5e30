using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Aligns lines in the width of their column and writes their letters and rules.</summary>
/// <param name="standard">The alignment of paragraphs that do not state one.</param>
/// <param name="width">Of a column.</param>
internal sealed class LineWriter(ParagraphAlignment standard, double width, bool isWrapped)
{
    public List<GlyphPlace> Glyphs { get; } = [];

    public List<LayoutRule> Rules { get; } = [];

    /// <param name="left">Of the column.</param>
    public void Write(SetLine line, double left, double baseline)
    {
        var (shift, perBlank, perLetter) = SpreadOf(line);
        var firstSpread = FirstSpread(line);
        var marked = default(MarkedRun?);
        var added = 0.0;
        for (var i = 0; i < line.Items.Count; i++)
        {
            var (item, place) = line.Items[i];
            var x = left + shift + place + added;
            var y = baseline + line.ShiftOf(item);
            for (var k = 0; k < item.Glyphs.Count; k++) Glyphs.Add(item.Glyphs[k].MovedBy(x + (item.Kind == LineItemKind.Letters ? k * perLetter : 0.0), y));
            Rules.AddRange(item.Rules.Select(rule => new LayoutRule(rule.From + new Vector2D(x, y), rule.To + new Vector2D(x, y))));
            if (i >= firstSpread) added += item.Kind is LineItemKind.Blank or LineItemKind.FixedBlank ? perBlank + perLetter : perLetter * LettersOf(item);
            var end = i + 1 < line.Items.Count ? left + shift + line.Items[i + 1].X + added : x + item.Advance + (perLetter * Math.Max(0, LettersOf(item) - 1));
            marked = Mark(marked, new MarkedRun(item, x, end, y));
        }

        Mark(marked, null);
    }

    /// <summary>Units between which letters are spread.</summary>
    private static int LettersOf(LineItem item) => item.Kind switch
    {
        LineItemKind.Letters => item.Glyphs.Count,
        LineItemKind.Tab => 0,
        _ => 1,
    };

    /// <summary>The items after the last tab are spread, from the first with letters on.</summary>
    private static int FirstSpread(SetLine line)
    {
        var first = line.Items.Count;
        for (var i = line.Items.Count - 1; i >= 0 && line.Items[i].Item.Kind != LineItemKind.Tab; i--)
        {
            if (line.Items[i].Item.HasInk) first = i;
        }

        return first;
    }

    private (double Shift, double PerBlank, double PerLetter) SpreadOf(SetLine line)
    {
        var right = width - line.Paragraph.Right;
        var rest = right - line.ContentRight;
        var alignment = line.Paragraph.Format.Alignment is var stated && stated == ParagraphAlignment.Default ? standard : stated;
        return alignment switch
        {
            _ when !line.HasInk => default,
            ParagraphAlignment.Right => (rest, 0.0, 0.0),
            ParagraphAlignment.Centre => (((line.Left + right) - (line.ContentLeft + line.ContentRight)) / 2.0, 0.0, 0.0),
            ParagraphAlignment.Justified when line.End == SetLineEnd.Wrapped && rest > 0.0 && BlanksOf(line) is > 0 and var blanks => (0.0, rest / blanks, 0.0),
            ParagraphAlignment.Distributed when isWrapped && rest > 0.0 && GapsOf(line) is > 0 and var gaps => (0.0, 0.0, rest / gaps),
            _ => default,
        };
    }

    private static int BlanksOf(SetLine line) => Inner(line).Count(item => item.Kind is LineItemKind.Blank or LineItemKind.FixedBlank);

    private static int GapsOf(SetLine line) => Inner(line).Sum(LettersOf) - 1;

    /// <summary>From the first to the last item with letters, after the last tab.</summary>
    private static IEnumerable<LineItem> Inner(SetLine line)
    {
        var items = line.Items.Skip(FirstSpread(line)).Select(place => place.Item).ToArray();
        return items.Take(Array.FindLastIndex(items, item => item.HasInk) + 1);
    }

    /// <summary>Joins an item to the marked run before it, or writes the rules of that run.</summary>
    private MarkedRun? Mark(MarkedRun? run, MarkedRun? next)
    {
        if (run is { } before && next is { } after && before.Joins(after)) return before with { To = after.To };
        if (run is { } finished) finished.Write(Rules);
        return next;
    }

    /// <summary>Items of one format beside each other.</summary>
    private readonly record struct MarkedRun(LineItem Item, double From, double To, double Baseline)
    {
        private bool IsStack => Item.Kind == LineItemKind.Stack;

        public bool Joins(MarkedRun next) => !IsStack && !next.IsStack && Item.Format.Marks == next.Item.Format.Marks && Item.Format.Letters == next.Item.Format.Letters && Baseline.Equals(next.Baseline);

        public void Write(List<LayoutRule> rules)
        {
            var (marks, letters) = (Item.Format.Marks, Item.Format.Letters);
            if (!IsStack)
            {
                LineLayout.AddRules(rules, marks, letters, From, To, Baseline);
                return;
            }

            LineLayout.AddRules(rules, marks & LineMarks.Underline, letters, From, To, Baseline);
            LineLayout.AddRules(rules, marks & LineMarks.Overline, letters, From, To, Baseline + Item.Body - letters.Height);
            LineLayout.AddRules(rules, marks & LineMarks.StrikeThrough, letters, From, To, Baseline + ((Item.Body - letters.Height) / 2.0));
        }
    }
}
