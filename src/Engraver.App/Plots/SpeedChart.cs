using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Input;
using Avalonia.Media;
using Engraver.App.Texts;

namespace Engraver.App.Plots;

/// <summary>Draws a speed curve over time; a press or a drag selects a time.</summary>
public sealed class SpeedChart : Control
{
    private const double LeftRoom = 46;
    private const double BottomRoom = 22;
    private const double TopRoom = 22;
    private const double RightRoom = 10;
    private const double CursorWidth = 2;

    /// <summary>Feeds are shown in mm/min, as in the rest of the desktop.</summary>
    private const double SecondsPerMinute = 60.0;

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

    /// <summary>The brush of the line at the position of the playback.</summary>
    public IBrush? CursorBrush
    {
        get => GetValue(CursorBrushProperty);
        set => SetValue(CursorBrushProperty, value);
    }

    private Rect PlotArea => new(LeftRoom, TopRoom, Math.Max(1.0, Bounds.Width - LeftRoom - RightRoom), Math.Max(1.0, Bounds.Height - TopRoom - BottomRoom));

    public override void Render(DrawingContext context)
    {
        context.FillRectangle(Brushes.Transparent, new Rect(Bounds.Size));
        if (Curve is not { Peak: > 0.0, TotalSeconds: > 0.0 } curve) return;
        var field = PlotArea;
        var speeds = ChartTicks.Speeds(curve.Peak * SecondsPerMinute, field.Height);
        DrawGrid(context, field, speeds, curve.TotalSeconds);
        context.DrawGeometry(null, new Pen(LineBrush, 1.2), LineOf(curve, field, speeds[^1]));
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

    private static StreamGeometry LineOf(SpeedCurve curve, Rect field, double top)
    {
        var line = new StreamGeometry();
        using var pen = line.Open();
        pen.BeginFigure(field.BottomLeft, isFilled: false);
        foreach (var sample in curve.Samples)
        {
            pen.LineTo(new Point(field.X + (field.Width * sample.Seconds / curve.TotalSeconds), field.Bottom - (field.Height * sample.Speed * SecondsPerMinute / top)));
        }

        pen.EndFigure(isClosed: false);
        return line;
    }

    /// <param name="speeds">mm/min; the last is the top of the plot area.</param>
    private void DrawGrid(DrawingContext context, Rect field, IReadOnlyList<double> speeds, double totalSeconds)
    {
        var pen = new Pen(GridBrush);
        foreach (var speed in speeds)
        {
            var y = field.Bottom - (field.Height * speed / speeds[^1]);
            context.DrawLine(pen, new Point(field.X, y), new Point(field.Right, y));
            var label = LabelOf(speed.ToString("0.##", CultureInfo.InvariantCulture));
            context.DrawText(label, new Point(field.X - 6 - label.Width, y - (label.Height / 2)));
        }

        context.DrawText(LabelOf(Text.Get("Plot.Axis")), new Point(6, 2));
        foreach (var seconds in ChartTicks.Seconds(totalSeconds, field.Width))
        {
            var x = field.X + (field.Width * seconds / totalSeconds);
            context.DrawLine(pen, new Point(x, field.Y), new Point(x, field.Bottom));
            var label = LabelOf(ClockText.Format(seconds));
            context.DrawText(label, new Point(Math.Min(x - (label.Width / 2), Bounds.Width - label.Width - 2), field.Bottom + 4));
        }
    }

    private FormattedText LabelOf(string text) =>
        new(text, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, new Typeface(TextElement.GetFontFamily(this)), 11, TextElement.GetForeground(this));

    private void Choose(Point place)
    {
        if (Curve is { } curve) At = curve.TotalSeconds * Math.Clamp((place.X - PlotArea.X) / PlotArea.Width, 0.0, 1.0);
    }
}
