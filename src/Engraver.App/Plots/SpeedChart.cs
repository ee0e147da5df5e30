using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Input;
using Avalonia.Media;
using Engraver.App.Texts;

namespace Engraver.App.Plots;

/// <summary>Draws a speed curve over time; a press or a drag chooses a moment.</summary>
public sealed class SpeedChart : Control
{
    private const double LeftRoom = 46;
    private const double BottomRoom = 22;
    private const double TopRoom = 22;
    private const double RightRoom = 10;
    private const double CursorWidth = 2;

    public static readonly StyledProperty<SpeedCurve?> CurveProperty = AvaloniaProperty.Register<SpeedChart, SpeedCurve?>(nameof(Curve));
    public static readonly StyledProperty<double> AtProperty = AvaloniaProperty.Register<SpeedChart, double>(nameof(At), defaultBindingMode: Avalonia.Data.BindingMode.TwoWay);
    public static readonly StyledProperty<IBrush?> LineBrushProperty = AvaloniaProperty.Register<SpeedChart, IBrush?>(nameof(LineBrush));
    public static readonly StyledProperty<IBrush?> GridBrushProperty = AvaloniaProperty.Register<SpeedChart, IBrush?>(nameof(GridBrush));
    public static readonly StyledProperty<IBrush?> CursorBrushProperty = AvaloniaProperty.Register<SpeedChart, IBrush?>(nameof(CursorBrush));

    static SpeedChart() => AffectsRender<SpeedChart>(CurveProperty, AtProperty, LineBrushProperty, GridBrushProperty, CursorBrushProperty, TextElement.ForegroundProperty);

    public SpeedCurve? Curve
    {
        get => GetValue(CurveProperty);
        set => SetValue(CurveProperty, value);
    }

    /// <summary>Seconds.</summary>
    public double At
    {
        get => GetValue(AtProperty);
        set => SetValue(AtProperty, value);
    }

    public IBrush? LineBrush
    {
        get => GetValue(LineBrushProperty);
        set => SetValue(LineBrushProperty, value);
    }

    public IBrush? GridBrush
    {
        get => GetValue(GridBrushProperty);
        set => SetValue(GridBrushProperty, value);
    }

    /// <summary>The moment of the tool.</summary>
    public IBrush? CursorBrush
    {
        get => GetValue(CursorBrushProperty);
        set => SetValue(CursorBrushProperty, value);
    }

    private Rect Field => new(LeftRoom, TopRoom, Math.Max(1.0, Bounds.Width - LeftRoom - RightRoom), Math.Max(1.0, Bounds.Height - TopRoom - BottomRoom));

    public override void Render(DrawingContext context)
    {
        context.FillRectangle(Brushes.Transparent, new Rect(Bounds.Size));
        if (Curve is not { Peak: > 0.0, TotalSeconds: > 0.0 } curve) return;
        var field = Field;
        DrawGrid(context, field, curve);
        context.DrawGeometry(null, new Pen(LineBrush, 1.2), LineOf(curve, field));
        var x = field.X + (field.Width * Math.Clamp(At / curve.TotalSeconds, 0.0, 1.0));
        context.DrawLine(new Pen(CursorBrush, CursorWidth), new Point(x, field.Y), new Point(x, field.Bottom));
    }

    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        base.OnPointerPressed(e);
        e.Pointer.Capture(this);
        Choose(e.GetPosition(this));
    }

    protected override void OnPointerMoved(PointerEventArgs e)
    {
        base.OnPointerMoved(e);
        if (e.GetCurrentPoint(this).Properties.IsLeftButtonPressed) Choose(e.GetPosition(this));
    }

    private static StreamGeometry LineOf(SpeedCurve curve, Rect field)
    {
        var line = new StreamGeometry();
        using var pen = line.Open();
        pen.BeginFigure(field.BottomLeft, isFilled: false);
        foreach (var sample in curve.Samples)
        {
            pen.LineTo(new Point(field.X + (field.Width * sample.Seconds / curve.TotalSeconds), field.Bottom - (field.Height * sample.Speed / curve.Peak)));
        }

        pen.EndFigure(isClosed: false);
        return line;
    }

    private void DrawGrid(DrawingContext context, Rect field, SpeedCurve curve)
    {
        const int Lines = 4;
        var pen = new Pen(GridBrush);
        for (var line = 0; line <= Lines; line++)
        {
            var y = field.Bottom - (field.Height * line / Lines);
            context.DrawLine(pen, new Point(field.X, y), new Point(field.Right, y));
            var label = LabelOf((curve.Peak * line / Lines).ToString("0.#", CultureInfo.InvariantCulture));
            context.DrawText(label, new Point(field.X - 6 - label.Width, y - (label.Height / 2)));
        }

        context.DrawText(LabelOf(Text.Of("Plot.Axis")), new Point(6, 2));
        context.DrawText(LabelOf(ClockText.Of(0)), new Point(field.X, field.Bottom + 4));
        var end = LabelOf(ClockText.Of(curve.TotalSeconds));
        context.DrawText(end, new Point(field.Right - end.Width, field.Bottom + 4));
    }

    private FormattedText LabelOf(string text) =>
        new(text, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, new Typeface(TextElement.GetFontFamily(this)), 11, TextElement.GetForeground(this));

    private void Choose(Point place)
    {
        if (Curve is { } curve) At = curve.TotalSeconds * Math.Clamp((place.X - Field.X) / Field.Width, 0.0, 1.0);
    }
}
