using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Engraver.App.Binding;
using Engraver.Workbench.Plots;
using ScottPlot;
using ScottPlot.Interactivity;
using ScottPlot.Interactivity.UserActionResponses;
using ScottPlot.Interactivity.UserActions;
using SkiaSharp;
using Cursor = ScottPlot.Cursor;
using Key = Avalonia.Input.Key;
using MouseButton = Avalonia.Input.MouseButton;
using PixelFormat = Avalonia.Platform.PixelFormat;
using PixelRect = ScottPlot.PixelRect;
using PixelSize = Avalonia.PixelSize;

namespace Engraver.App.Plots;

/// <summary>The stacked plots in the window. ScottPlot draws them into a bitmap and handles the pointer (wheel and right button zoom, left button pans, middle
/// button zooms to a rectangle); the position of the playback, the pointer and marked spans are drawn over the bitmap, so that they move without drawing
/// the curves again. A click seeks.</summary>
public sealed class PlotSurface : Control, IPlotControl, IArrowKeyTarget
{
    /// <summary>Movement of the pointer up to which a press and a release are a click.</summary>
    private const double ClickDistance = 3.0;

    private const double KeyZoom = 1.4;
    private const double KeyPan = 0.15;
    private const double MarkOpacity = 0.3;

    /// <summary>Part of the whole axis within which two ranges are the same.</summary>
    private const double RangeTolerance = 1e-9;

    public static readonly StyledProperty<PlotContent> ContentProperty = AvaloniaProperty.Register<PlotSurface, PlotContent>(nameof(Content), PlotContent.Nothing);
    public static readonly StyledProperty<double> PositionProperty = AvaloniaProperty.Register<PlotSurface, double>(nameof(Position));
    public static readonly StyledProperty<double?> PointedProperty = AvaloniaProperty.Register<PlotSurface, double?>(nameof(Pointed), defaultBindingMode: BindingMode.TwoWay);
    public static readonly StyledProperty<IReadOnlyList<(double Start, double End)>> MarksProperty = AvaloniaProperty.Register<PlotSurface, IReadOnlyList<(double Start, double End)>>(nameof(Marks), []);
    public static readonly StyledProperty<IBrush?> PositionBrushProperty = AvaloniaProperty.Register<PlotSurface, IBrush?>(nameof(PositionBrush));
    public static readonly StyledProperty<IBrush?> PointedBrushProperty = AvaloniaProperty.Register<PlotSurface, IBrush?>(nameof(PointedBrush));
    public static readonly StyledProperty<IBrush?> MarkBrushProperty = AvaloniaProperty.Register<PlotSurface, IBrush?>(nameof(MarkBrush));

    private readonly WriteableBitmap?[] _bitmaps = new WriteableBitmap?[2];
    private int _shown;
    private bool _isOutdated = true;
    private double _builtScale;
    private PlotContent _built = PlotContent.Nothing;
    private Avalonia.Point? _pressed;
    private bool _isDragging;

    static PlotSurface() => AffectsRender<PlotSurface>(PositionProperty, PointedProperty, MarksProperty, PositionBrushProperty, PointedBrushProperty, MarkBrushProperty);

    public PlotSurface()
    {
        Multiplot = new Multiplot();
        UserInputProcessor = new UserInputProcessor(this);
        UserInputProcessor.UserActionResponses.Clear();
        UserInputProcessor.UserActionResponses.AddRange(
        [
            new MouseDragPan(StandardMouseButtons.Left), new MouseDragZoom(StandardMouseButtons.Right), new MouseDragZoomRectangle(StandardMouseButtons.Middle),
            new MouseWheelZoom(StandardKeys.Shift, StandardKeys.Control),
        ]);
        ActualThemeVariantChanged += (_, _) => Rebuild();
        (Focusable, ClipToBounds) = (true, true);
    }

    /// <summary>Raised with the place of the common axis that was clicked.</summary>
    public event EventHandler<double>? Sought;

    public PlotContent Content
    {
        get => GetValue(ContentProperty);
        set => SetValue(ContentProperty, value);
    }

    /// <summary>Place of the playback on the common axis.</summary>
    public double Position
    {
        get => GetValue(PositionProperty);
        set => SetValue(PositionProperty, value);
    }

    /// <summary>Place of the common axis under the pointer; null while the pointer is elsewhere.</summary>
    public double? Pointed
    {
        get => GetValue(PointedProperty);
        set => SetValue(PointedProperty, value);
    }

    /// <summary>Marked spans of the common axis.</summary>
    public IReadOnlyList<(double Start, double End)> Marks
    {
        get => GetValue(MarksProperty);
        set => SetValue(MarksProperty, value);
    }

    public IBrush? PositionBrush
    {
        get => GetValue(PositionBrushProperty);
        set => SetValue(PositionBrushProperty, value);
    }

    public IBrush? PointedBrush
    {
        get => GetValue(PointedBrushProperty);
        set => SetValue(PointedBrushProperty, value);
    }

    public IBrush? MarkBrush
    {
        get => GetValue(MarkBrushProperty);
        set => SetValue(MarkBrushProperty, value);
    }

    /// <summary>The visible range of the common axis.</summary>
    public (double Start, double End) VisibleRange => HasPlots && Plot.Axes.Bottom is { } axis ? (axis.Min, axis.Max) : default;

    /// <summary>A part of the axis is visible, not the whole.</summary>
    public bool IsZoomed => _built is { End: > 0.0 and var whole, Panels.Count: > 0 } && VisibleRange is var (start, end) && (start > RangeTolerance * whole || end < (1.0 - RangeTolerance) * whole);

    public IMultiplot Multiplot { get; set; }

    public Plot Plot => Multiplot.Subplots.GetPlot(0);

    public UserInputProcessor UserInputProcessor { get; }

    IPlotMenu? IPlotControl.Menu { get; set; }

    GRContext? IPlotControl.GRContext => null;

    public float DisplayScale { get; set; } = 1.0f;

    /// <summary>Without a plot ScottPlot handles no input.</summary>
    private bool HasPlots => Multiplot.Subplots.Count > 0;

    private double Scaling => TopLevel.GetTopLevel(this)?.RenderScaling ?? 1.0;

    /// <summary>Shows the whole axis.</summary>
    public void Fit() => Show(0.0, _built.End);

    /// <summary>Shows a range of the axis, limited to the motion.</summary>
    public void Show(double start, double end)
    {
        if (!(end > start)) return;
        SetRange(start, end);
        Refresh();
    }

    /// <summary>Draws the curves again.</summary>
    public void Refresh()
    {
        _isOutdated = true;
        InvalidateVisual();
    }

    void IPlotControl.ShowContextMenu(Pixel position)
    {
    }

    float IPlotControl.DetectDisplayScale() => (float)Scaling;

    void IPlotControl.Reset()
    {
    }

    void IPlotControl.Reset(Plot plot)
    {
    }

    void IPlotControl.SetCursor(Cursor cursor)
    {
    }

    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        context.FillRectangle(Brushes.Transparent, new Rect(Bounds.Size));
        var size = PixelSize.FromSize(Bounds.Size, Scaling);
        if (_built.Panels.Count == 0 || size.Width < 1 || size.Height < 1) return;
        if (_builtScale != Scaling && !_isDragging) Build();
        if (_isOutdated || _bitmaps[_shown]?.PixelSize != size) Draw(size);
        using (context.PushRenderOptions(new RenderOptions { BitmapInterpolationMode = BitmapInterpolationMode.None }))
        {
            context.DrawImage(_bitmaps[_shown]!, new Rect(0.0, 0.0, size.Width, size.Height), new Rect(0.0, 0.0, size.Width / Scaling, size.Height / Scaling));
        }

        foreach (var plot in Multiplot.Subplots.GetPlots()) DrawOver(context, plot);
    }

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == ContentProperty && !_isDragging) Rebuild();
        else if (change.Property == BoundsProperty) Refresh();
    }

    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerPressed(e);
        var point = e.GetCurrentPoint(this);
        IUserAction? action = point.Properties.PointerUpdateKind switch
        {
            PointerUpdateKind.LeftButtonPressed => new LeftMouseDown(PixelOf(point.Position)),
            PointerUpdateKind.RightButtonPressed => new RightMouseDown(PixelOf(point.Position)),
            PointerUpdateKind.MiddleButtonPressed => new MiddleMouseDown(PixelOf(point.Position)),
            _ => null,
        };
        if (action is null || !HasPlots) return;
        Focus();
        e.Pointer.Capture(this);
        e.Handled = true;
        _pressed = point.Properties.PointerUpdateKind == PointerUpdateKind.LeftButtonPressed ? point.Position : null;
        _isDragging = true;
        UserInputProcessor.Process(action);
    }

    protected override void OnPointerMoved(PointerEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerMoved(e);
        if (!HasPlots) return;
        var at = e.GetPosition(this);
        if (_pressed is { } pressed && Avalonia.Point.Distance(pressed, at) > ClickDistance) _pressed = null;
        if (_pressed is null) UserInputProcessor.Process(new MouseMove(PixelOf(at)));
        Pointed = PlaceAt(at);
    }

    protected override void OnPointerReleased(PointerReleasedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerReleased(e);
        var at = e.GetPosition(this);
        IUserAction? action = e.InitialPressMouseButton switch
        {
            MouseButton.Left => new LeftMouseUp(PixelOf(at)),
            MouseButton.Right => new RightMouseUp(PixelOf(at)),
            MouseButton.Middle => new MiddleMouseUp(PixelOf(at)),
            _ => null,
        };
        if (action is null || !HasPlots) return;
        UserInputProcessor.Process(action);
        if (_pressed is not null && e.InitialPressMouseButton == MouseButton.Left && PlaceAt(at) is { } place) Sought?.Invoke(this, Math.Clamp(place, 0.0, Content.End));
        EndDrag();
    }

    protected override void OnPointerCaptureLost(PointerCaptureLostEventArgs e)
    {
        base.OnPointerCaptureLost(e);
        if (!_isDragging) return;
        UserInputProcessor.ResetState(this);
        EndDrag();
    }

    protected override void OnPointerWheelChanged(PointerWheelEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerWheelChanged(e);
        if (!HasPlots) return;
        var pixel = PixelOf(e.GetPosition(this));
        if (e.Delta.Y != 0.0) UserInputProcessor.Process(e.Delta.Y > 0.0 ? new MouseWheelUp(pixel) : new MouseWheelDown(pixel));
        e.Handled = true;
    }

    protected override void OnPointerExited(PointerEventArgs e)
    {
        base.OnPointerExited(e);
        Pointed = null;
    }

    protected override void OnKeyDown(KeyEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnKeyDown(e);
        if (e.Handled || e.KeyModifiers != KeyModifiers.None || !HasPlots) return;
        var (start, end) = VisibleRange;
        var (middle, span) = ((start + end) / 2.0, end - start);
        (double Start, double End)? next = e.Key switch
        {
            Key.Home => (0.0, Content.End),
            Key.Up => (middle - (span / 2.0 / KeyZoom), middle + (span / 2.0 / KeyZoom)),
            Key.Down => (middle - (span / 2.0 * KeyZoom), middle + (span / 2.0 * KeyZoom)),
            Key.Left when Math.Min(start, KeyPan * span) is var step => (start - step, end - step),
            Key.Right when Math.Min(Content.End - end, KeyPan * span) is var step => (start + step, end + step),
            _ => null,
        };
        if (next is not { } range) return;
        Show(range.Start, range.End);
        e.Handled = true;
    }

    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        UserInputProcessor.ProcessLostFocus();
        for (var i = 0; i < _bitmaps.Length; i++)
        {
            _bitmaps[i]?.Dispose();
            _bitmaps[i] = null;
        }
    }

    /// <summary>Content that changed during a drag is built at its end, so that the drag is not interrupted by a job that runs.</summary>
    private void EndDrag()
    {
        (_pressed, _isDragging) = (null, false);
        if (!ReferenceEquals(_built, Content)) Rebuild();
    }

    private void SetRange(double start, double end)
    {
        foreach (var plot in Multiplot.Subplots.GetPlots()) plot.Axes.SetLimitsX(Math.Max(start, 0.0), Math.Min(end, _built.End));
    }

    private void Rebuild()
    {
        Build();
        InvalidateVisual();
    }

    /// <summary>Makes the plots of the content; a range to which the operator has zoomed stays while the axis is the same. Also called while the control is
    /// drawn, after a change of the scaling, so it does not ask for another drawing.</summary>
    private void Build()
    {
        (double, double)? kept = IsZoomed && _built.Axis == Content.Axis ? VisibleRange : null;
        _built = Content;
        foreach (var plot in Multiplot.Subplots.GetPlots()) plot.Dispose();
        (_builtScale, DisplayScale, _isOutdated) = (Scaling, (float)Scaling, true);
        Multiplot = PlotPicture.Create(Content, PlotColours.Of(this, ActualThemeVariant), Scaling, hasLegend: false);
        UserInputProcessor.ResetState(this);
        if (kept is var (start, end) && start < Content.End) SetRange(start, end);
    }

    /// <summary>Draws into the bitmap that is not on the screen.</summary>
    private void Draw(PixelSize size)
    {
        _shown = 1 - _shown;
        if (_bitmaps[_shown]?.PixelSize != size)
        {
            _bitmaps[_shown]?.Dispose();
            _bitmaps[_shown] = new WriteableBitmap(size, new Vector(96.0, 96.0), PixelFormat.Bgra8888, AlphaFormat.Opaque);
        }

        using var locked = _bitmaps[_shown]!.Lock();
        using var surface = SKSurface.Create(new SKImageInfo(size.Width, size.Height, SKColorType.Bgra8888, SKAlphaType.Opaque), locked.Address, locked.RowBytes);
        Multiplot.Render(surface.Canvas, new PixelRect(0.0f, size.Width, size.Height, 0.0f));
        _isOutdated = false;
    }

    private void DrawOver(DrawingContext context, Plot plot)
    {
        var field = plot.LastRender.DataRect;
        var (top, height) = (field.Top / Scaling, field.Height / Scaling);
        var area = new Rect(field.Left / Scaling, top, field.Width / Scaling, height);
        using var clip = context.PushClip(area);
        using (context.PushOpacity(MarkOpacity))
        {
            foreach (var (start, end) in Marks)
            {
                var (left, right) = (XOf(plot, start), XOf(plot, end));
                if (MarkBrush is { } brush && right >= area.Left && left <= area.Right) context.FillRectangle(brush, new Rect(left, top, Math.Max(1.0, right - left), height));
            }
        }

        if (Pointed is { } pointed) Line(PointedBrush, pointed, 1.0);
        Line(PositionBrush, Position, 2.0);

        void Line(IBrush? brush, double place, double width) => context.DrawLine(new Pen(brush, width), new Avalonia.Point(XOf(plot, place), top), new Avalonia.Point(XOf(plot, place), top + height));
    }

    private double XOf(Plot plot, double place) => plot.GetPixel(new Coordinates(place, 0.0)).X / Scaling;

    /// <summary>The place of the common axis at a point of the window; null beside the axis.</summary>
    private double? PlaceAt(Avalonia.Point point)
    {
        if (!HasPlots || Plot.LastRender.DataRect is not { Width: > 0.0f } field) return null;
        var pixel = PixelOf(point);
        return field.ContainsX(pixel.X) ? Plot.GetCoordinates(pixel).X : null;
    }

    private Pixel PixelOf(Avalonia.Point point) => new(point.X * Scaling, point.Y * Scaling);
}
