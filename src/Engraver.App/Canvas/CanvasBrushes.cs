using Avalonia.Media;

namespace Engraver.App.Canvas;

/// <summary>Pens and brushes from the colours of the canvas.</summary>
internal static class CanvasBrushes
{
    public static IBrush Brush(uint colour, double opacity = 1.0) => new Avalonia.Media.Immutable.ImmutableSolidColorBrush(Color.FromUInt32(colour), opacity);

    public static IPen Pen(uint colour, double thickness = 1.0, bool dashed = false) =>
        new Pen(Brush(colour), thickness, dashed ? new DashStyle([4.0, 3.0], 0.0) : null).ToImmutable();
}
