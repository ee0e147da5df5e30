namespace Engraver.Core.Drawings;

/// <summary>The line styles of a drawing while entities are scaled: the width of a polyline is scaled with it. Existing styles are kept.</summary>
internal sealed class EditedStyles(Drawing drawing, double scale)
{
    private readonly List<LineStyle> _styles = [.. drawing.LineStyles];

    /// <summary>Number of the style of an entity after it is scaled.</summary>
    public int Scaled(int style)
    {
        if (scale == 1.0 || _styles[style].Width == 0.0) return style;
        var scaled = _styles[style] with { Width = _styles[style].Width * scale };
        var number = _styles.IndexOf(scaled);
        if (number >= 0) return number;
        _styles.Add(scaled);
        return _styles.Count - 1;
    }

    public IReadOnlyList<LineStyle> ToList() => _styles.Count == drawing.LineStyles.Count ? drawing.LineStyles : _styles;
}
