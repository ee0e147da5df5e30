using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;

namespace Engraver.App.MachineStrip;

/// <summary>Eight inputs or outputs as small squares, number 1 at the left: filled is on, hollow is off, a dot is unknown.</summary>
public sealed class BitLamps : Control
{
    private const int Count = 8;
    private const double Side = 7.0;
    private const double Pitch = 10.0;

    public static readonly StyledProperty<int?> BitsProperty = AvaloniaProperty.Register<BitLamps, int?>(nameof(Bits));
    public static readonly StyledProperty<IBrush?> ForegroundProperty = AvaloniaProperty.Register<BitLamps, IBrush?>(nameof(Foreground));

    static BitLamps() => AffectsRender<BitLamps>(BitsProperty, ForegroundProperty);

    /// <summary>Bit 0 is number 1; null: unknown.</summary>
    public int? Bits
    {
        get => GetValue(BitsProperty);
        set => SetValue(BitsProperty, value);
    }

    public IBrush? Foreground
    {
        get => GetValue(ForegroundProperty);
        set => SetValue(ForegroundProperty, value);
    }

    public override void Render(DrawingContext context)
    {
        var pen = new Pen(Foreground);
        for (var i = 0; i < Count; i++)
        {
            var lamp = new Rect((i * Pitch) + 0.5, 0.5, Side, Side);
            if (Bits is not { } bits) context.FillRectangle(Foreground!, lamp.Deflate(2.5));
            else if ((bits & (1 << i)) != 0) context.FillRectangle(Foreground!, lamp.Inflate(0.5));
            else context.DrawRectangle(pen, lamp);
        }
    }

    protected override Size MeasureOverride(Size availableSize) => new((Count * Pitch) - Pitch + Side + 1.0, Side + 1.0);
}
