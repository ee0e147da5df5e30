using System.Text.RegularExpressions;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Media;

namespace Engraver.App.CommandWindow;

/// <summary>A line of the history. Two or more spaces between words are a tabulator: commands pad their columns for a terminal, and here the columns are
/// aligned in any font. The last column wraps.</summary>
public sealed partial class ColumnText : Panel
{
    public static readonly StyledProperty<HistoryLine?> LineProperty = AvaloniaProperty.Register<ColumnText, HistoryLine?>(nameof(Line));

    /// <summary>The width of one character of a terminal, units of 1/96 inch: a capital of the history's font, so that a name in capitals ends before the
    /// next column.</summary>
    private const double Pitch = 7.6;

    /// <summary>Minimum space between two columns.</summary>
    private const double Gap = 10;

    private IReadOnlyList<int> _columns = [];

    static ColumnText() => LineProperty.Changed.AddClassHandler<ColumnText>((text, _) => text.Fill());

    public HistoryLine? Line
    {
        get => GetValue(LineProperty);
        set => SetValue(LineProperty, value);
    }

    /// <summary>The parts of a line with the character at which each starts; a line without columns is one part with its indentation.</summary>
    public static IReadOnlyList<(int Column, string Text)> PartsOf(string line)
    {
        ArgumentNullException.ThrowIfNull(line);
        return line.Trim().Length == 0 ? [(0, "")] : [.. Part().Matches(line).Select(match => (match.Index, match.Value))];
    }

    protected override Size MeasureOverride(Size availableSize)
    {
        var (left, height, right) = (0.0, 0.0, 0.0);
        for (var i = 0; i < Children.Count; i++)
        {
            left = LeftOf(i, right);
            Children[i].Measure(new Size(i == Children.Count - 1 ? Math.Max(0, availableSize.Width - left) : double.PositiveInfinity, double.PositiveInfinity));
            right = left + Children[i].DesiredSize.Width;
            height = Math.Max(height, Children[i].DesiredSize.Height);
        }

        return new Size(Math.Min(right, availableSize.Width), height);
    }

    protected override Size ArrangeOverride(Size finalSize)
    {
        var right = 0.0;
        for (var i = 0; i < Children.Count; i++)
        {
            var left = LeftOf(i, right);
            var width = i == Children.Count - 1 ? Math.Max(0, finalSize.Width - left) : Children[i].DesiredSize.Width;
            Children[i].Arrange(new Rect(left, 0, width, finalSize.Height));
            right = left + width;
        }

        return finalSize;
    }

    [GeneratedRegex(@"\S+(?: \S+)*")]
    private static partial Regex Part();

    /// <summary>A part is at its column, or after a longer part before it.</summary>
    private double LeftOf(int part, double right) => part == 0 ? _columns[0] * Pitch / 2 : Math.Max(_columns[part] * Pitch, right + Gap);

    private void Fill()
    {
        Children.Clear();
        if (Line is not { } line) return;
        var parts = PartsOf(line.Text);
        _columns = [.. parts.Select(part => part.Column)];
        foreach (var (_, text) in parts) Children.Add(Block(line, text));
        Children[^1].SetValue(TextBlock.TextWrappingProperty, TextWrapping.Wrap);
        InvalidateMeasure();
    }

    private static TextBlock Block(HistoryLine line, string text)
    {
        var block = new TextBlock { Text = text, VerticalAlignment = VerticalAlignment.Top };
        block.Classes.Set("error", line.IsError);
        block.Classes.Set("warning", line.IsWarning);
        block.Classes.Set("quiet", line.IsNote);
        return block;
    }
}
