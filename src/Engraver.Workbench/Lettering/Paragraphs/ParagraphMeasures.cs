using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>The lengths of a paragraph's format in drawing units.</summary>
/// <param name="unit">Height of the entity.</param>
internal sealed class ParagraphMeasures(ParagraphFormat format, double unit)
{
    /// <summary>Distance of the tab stops that are not stated, as a multiple of the height. AutoCAD's default.</summary>
    private const double DefaultTab = 4.0;

    /// <summary>A stop this near is that of the tab before, as a multiple of the height.</summary>
    private const double SameStop = 1e-6;

    private readonly TabStop[] _stops = [.. format.Tabs.OrderBy(stop => stop.Position)];

    public ParagraphFormat Format => format;

    public double Unit => unit;

    public double Left => format.Left * unit;

    public double FirstLeft => (format.Left + format.Indent) * unit;

    public double Right => format.Right * unit;

    public double SpaceBefore => format.SpaceBefore * unit;

    public double SpaceAfter => format.SpaceAfter * unit;

    /// <summary>The first tab stop after a place in the line; after those of the format, one at every multiple of four heights.</summary>
    public (double Position, ParagraphAlignment Alignment) StopAfter(double x)
    {
        var at = (x / unit) + SameStop;
        var (first, end) = (0, _stops.Length);
        while (first < end)
        {
            var middle = (first + end) / 2;
            if (_stops[middle].Position > at) end = middle;
            else first = middle + 1;
        }

        if (first < _stops.Length) return (_stops[first].Position * unit, _stops[first].Alignment);
        return (DefaultTab * (Math.Floor(at / DefaultTab) + 1.0) * unit, ParagraphAlignment.Left);
    }
}
