using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Media;
using Avalonia.Threading;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Interaction;
using Engraver.App.Canvas.Overlays;
using Engraver.App.Canvas.Pictures;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas;

/// <summary>The control that shows drawing and path; <see cref="Commands"/> decides what a click does, <see cref="View"/> which part is seen. What the mouse
/// does is handled by <see cref="CanvasPointing"/>.</summary>
public sealed class DrawingCanvas : Panel
{
    public static readonly StyledProperty<CanvasScene?> SceneProperty = AvaloniaProperty.Register<DrawingCanvas, CanvasScene?>(nameof(Scene));
    public static readonly StyledProperty<OverlayScene?> OverlayProperty = AvaloniaProperty.Register<DrawingCanvas, OverlayScene?>(nameof(Overlay));
    public static readonly StyledProperty<ViewSession?> ViewProperty = AvaloniaProperty.Register<DrawingCanvas, ViewSession?>(nameof(View));
    public static readonly StyledProperty<IReadOnlyList<int>?> SelectionProperty = AvaloniaProperty.Register<DrawingCanvas, IReadOnlyList<int>?>(nameof(Selection));
    public static readonly StyledProperty<int?> HighlightProperty = AvaloniaProperty.Register<DrawingCanvas, int?>(nameof(Highlight));
    public static readonly StyledProperty<Point2D?> PlaybackPositionProperty = AvaloniaProperty.Register<DrawingCanvas, Point2D?>(nameof(PlaybackPosition));
    public static readonly StyledProperty<MachineMark?> MachineProperty = AvaloniaProperty.Register<DrawingCanvas, MachineMark?>(nameof(Machine));
    public static readonly StyledProperty<int> EngravedMovesProperty = AvaloniaProperty.Register<DrawingCanvas, int>(nameof(EngravedMoves));

    public static readonly StyledProperty<bool> ShowsGripsProperty = AvaloniaProperty.Register<DrawingCanvas, bool>(nameof(ShowsGrips), defaultValue: true);

    private readonly PictureCache _cache = new();
    private IReadOnlyList<int>? _flaggedSelection;
    private readonly CanvasPicture _picture;
    private readonly CanvasMarkers _markers = new() { IsHitTestVisible = false };
    private readonly CanvasCursor _cursor = new() { IsHitTestVisible = false };
    private readonly MachineNote _note = new();
    private readonly PictureRefiner _refiner;

    public DrawingCanvas()
    {
        _picture = new CanvasPicture(_cache) { IsHitTestVisible = false };
        Children.AddRange([_picture, _markers, _cursor, _note]);
        (Background, Focusable, ClipToBounds, Cursor) = (Brushes.Transparent, true, true, new Cursor(StandardCursorType.None));
        _refiner = new PictureRefiner(_cache);
        Pointing = new CanvasPointing(this, _markers, _cursor);
        _cache.Refined += (_, _) =>
        {
            _picture.InvalidateVisual();
            PictureDrawn?.Invoke();
        };
    }

    /// <summary>The drawing; null: none is open.</summary>
    public CanvasScene? Scene
    {
        get => GetValue(SceneProperty);
        set => SetValue(SceneProperty, value);
    }

    /// <summary>The overlays of the prepared job; null: none.</summary>
    public OverlayScene? Overlay
    {
        get => GetValue(OverlayProperty);
        set => SetValue(OverlayProperty, value);
    }

    /// <summary>The part of the drawing that is seen, and which overlays are shown.</summary>
    public ViewSession? View
    {
        get => GetValue(ViewProperty);
        set => SetValue(ViewProperty, value);
    }

    /// <summary>Selected entities.</summary>
    public IReadOnlyList<int>? Selection
    {
        get => GetValue(SelectionProperty);
        set => SetValue(SelectionProperty, value);
    }

    /// <summary>The selection shows its grips and can be dragged by them: not while a command asks for something else.</summary>
    public bool ShowsGrips
    {
        get => GetValue(ShowsGripsProperty);
        set => SetValue(ShowsGripsProperty, value);
    }

    /// <summary>The entity under the playback, of the table row or of the program line; null: none.</summary>
    public int? Highlight
    {
        get => GetValue(HighlightProperty);
        set => SetValue(HighlightProperty, value);
    }

    /// <summary>Where the playback is, drawing units; null: it is not looked at.</summary>
    public Point2D? PlaybackPosition
    {
        get => GetValue(PlaybackPositionProperty);
        set => SetValue(PlaybackPositionProperty, value);
    }

    /// <summary>Where the machine is; null: not known, or none is connected.</summary>
    public MachineMark? Machine
    {
        get => GetValue(MachineProperty);
        set => SetValue(MachineProperty, value);
    }

    /// <summary>How many cutting moves of the job are done, from its first one on.</summary>
    public int EngravedMoves
    {
        get => GetValue(EngravedMovesProperty);
        set => SetValue(EngravedMovesProperty, value);
    }

    /// <summary>A finished picture is there.</summary>
    internal event Action? PictureDrawn;

    /// <summary>Takes what the operator does on the canvas; null: the canvas only shows.</summary>
    public ICanvasCommands? Commands { get; set; }

    /// <summary>Length of the crosshair in percent of the canvas (CURSORSIZE).</summary>
    public double CursorSize
    {
        get => _cursor.CursorSize;
        set => _cursor.CursorSize = value;
    }

    /// <summary>The mouse on the canvas.</summary>
    internal CanvasPointing Pointing { get; }

    /// <summary>True when the finished picture is up to date and no picture is being drawn.</summary>
    public bool IsUpToDate => _cache.IsUpToDate;

    /// <summary>How long the view must rest before the picture is drawn again.</summary>
    internal TimeSpan RestDelay
    {
        get => _refiner.RestDelay;
        set => _refiner.RestDelay = value;
    }

    /// <summary>There is a picture of the scene, though not yet of everything that is wanted.</summary>
    internal bool HasPictureOfScene => _cache.HasPictureOf(Scene);

    /// <summary>The part of the drawing on the screen, in pixels of the screen.</summary>
    internal CanvasView PixelView => _cache.View;

    /// <summary>Drawing units per unit of the control.</summary>
    internal double UnitsPerPoint => _cache.View.UnitsPerPixel * Scaling;

    private double Scaling => TopLevel.GetTopLevel(this)?.RenderScaling ?? 1.0;

    /// <summary>Draws the wanted picture now, without waiting until the mouse rests: for screenshots and tests.</summary>
    public void RefineNow()
    {
        UpdateView();
        UpdateContent();
        _refiner.RefineNow();
    }

    /// <summary>Draws the picture although it is there already; for benchmarks.</summary>
    internal void ForceRefine()
    {
        _cache.CancelDrawing();
        _cache.Refine(CancellationToken.None);
    }

    /// <summary>From units of the control to drawing units.</summary>
    internal Point2D ToDrawing(Point2D at) => _cache.View.ToDrawing(new Point2D(at.X * Scaling, at.Y * Scaling));

    /// <summary>From drawing units to units of the control.</summary>
    internal Point ToControl(Point2D place)
    {
        var pixel = _cache.View.ToPixels(place);
        return new Point(pixel.X / Scaling, pixel.Y / Scaling);
    }

    internal void UpdateMarkers()
    {
        (_markers.Scene, _markers.View, _markers.Scaling, _markers.Colours) = (Scene, _cache.View, Scaling, _cache.Content.Theme);
        (_markers.Highlight, _markers.Machine, _markers.Playback, _markers.PointedAt) = (Highlight, Machine, PlaybackPosition, View?.Current.Focus?.Place);
        _note.Show(Machine?.Note ?? "");
        _markers.ShowGrips(ShowsGrips ? Selection ?? [] : [], Pointing.HeldGrip);
        _cursor.Colours = _cache.Content.Theme;
        _markers.InvalidateVisual();
        _cursor.InvalidateVisual();
    }

    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerPressed(e);
        Focus();
        if (ButtonOf(e.GetCurrentPoint(this).Properties.PointerUpdateKind) is not { } button) return;
        e.Pointer.Capture(this);
        Pointing.Press(PlaceOf(e), button, e.KeyModifiers.HasFlag(KeyModifiers.Shift), e.ClickCount);
        e.Handled = true;
    }

    protected override void OnPointerMoved(PointerEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerMoved(e);
        Pointing.Move(PlaceOf(e));
    }

    protected override void OnPointerReleased(PointerReleasedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerReleased(e);
        Pointing.Release(PlaceOf(e), ButtonOf(e.GetCurrentPoint(this).Properties.PointerUpdateKind));
        e.Pointer.Capture(null);
    }

    protected override void OnPointerWheelChanged(PointerWheelEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerWheelChanged(e);
        Pointing.Wheel(PlaceOf(e), e.Delta.Y);
        e.Handled = true;
    }

    protected override void OnPointerExited(PointerEventArgs e)
    {
        base.OnPointerExited(e);
        Pointing.Leave();
    }

    protected override void OnPointerCaptureLost(PointerCaptureLostEventArgs e)
    {
        base.OnPointerCaptureLost(e);
        if (Pointing.Pointer.IsPanning) Pointing.Pointer.OnCaptureLost();
    }

    protected override Size ArrangeOverride(Size finalSize)
    {
        var arranged = base.ArrangeOverride(finalSize);
        View?.SetCanvas(finalSize.Width, finalSize.Height);
        UpdateView(finalSize);
        UpdateContent();
        return arranged;
    }

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == ViewProperty) SubscribeToView(change.GetOldValue<ViewSession?>(), change.GetNewValue<ViewSession?>());
        else if (change.Property == HighlightProperty || change.Property == PlaybackPositionProperty || change.Property == MachineProperty || change.Property == ShowsGripsProperty) UpdateMarkers();
        else if (change.Property == SceneProperty) OnSceneChanged();
        else if (change.Property == OverlayProperty || change.Property == SelectionProperty || change.Property == EngravedMovesProperty) UpdateContent();
    }

    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        _refiner.Stop();
        base.OnDetachedFromVisualTree(e);
    }

    private void OnSceneChanged()
    {
        Pointing.DropScene();
        UpdateContent();
        UpdateMarkers();
        Pointing.RepeatMove();
    }

    private void SubscribeToView(ViewSession? before, ViewSession? now)
    {
        if (before is not null) before.Changed -= OnViewChanged;
        if (now is not null) now.Changed += OnViewChanged;
        now?.SetCanvas(Bounds.Width, Bounds.Height);
        UpdateView();
        UpdateContent();
    }

    /// <summary>May come from any thread.</summary>
    private void OnViewChanged(object? sender, EventArgs e)
    {
        if (Dispatcher.UIThread.CheckAccess()) OnViewUpdated();
        else Dispatcher.UIThread.Post(OnViewUpdated);
    }

    private void OnViewUpdated()
    {
        UpdateView();
        UpdateContent();
        UpdateMarkers();
        Pointing.RepeatMove();
    }

    private void UpdateView() => UpdateView(Bounds.Size);

    private void UpdateView(Size size)
    {
        var (scaling, state) = (Scaling, View?.Current ?? ViewState.Default);
        var pixels = new PixelSize((int)Math.Round(size.Width * scaling), (int)Math.Round(size.Height * scaling));
        if (pixels.Width <= 0 || pixels.Height <= 0) return;
        var view = new CanvasView(state.Centre, state.Height / pixels.Height, pixels);
        if (view == _cache.View) return;
        var before = _cache.View;
        _cache.View = view;
        if (_cache.Content.Scaling != scaling) Pointing.Pointer.DropBox(); // on another screen
        else Pointing.Pointer.ViewMoved(at => Moved(at, before));
        UpdateMarkers();
        _picture.InvalidateVisual();
        _refiner.OnViewMoving();
    }

    /// <summary>The present position of a point of the control that was drawn in an earlier view.</summary>
    private Point2D Moved(Point2D at, in CanvasView before)
    {
        var now = ToControl(before.ToDrawing(new Point2D(at.X * Scaling, at.Y * Scaling)));
        return new Point2D(now.X, now.Y);
    }

    private void UpdateContent()
    {
        var state = View?.Current ?? ViewState.Default;
        var content = _cache.Content with
        {
            Scene = Scene, Overlay = Overlay ?? OverlayScene.Empty, Shown = state.Shown, Grid = state.Grid, Theme = CanvasTheme.Of(state.Theme),
            Selected = Flags(Scene, Selection), EngravedMoves = EngravedMoves, Scaling = Scaling,
        };
        if (content == _cache.Content) return;
        _cache.Content = content;
        UpdateMarkers();
        _refiner.RefineSoon();
    }

    /// <summary>The selection as flags by entity; the same array while the selection is the same list, so that nothing is drawn again without need.</summary>
    private bool[]? Flags(CanvasScene? scene, IReadOnlyList<int>? selection)
    {
        if (scene is null || selection is not { Count: > 0 }) return null;
        if (ReferenceEquals(_flaggedSelection, selection) && _cache.Content.Selected is { } known && known.Length == scene.Shown.Entities.Count) return known;
        var flags = new bool[scene.Shown.Entities.Count];
        foreach (var entity in selection)
        {
            if ((uint)entity < (uint)flags.Length) flags[entity] = true;
        }

        _flaggedSelection = selection;
        return flags;
    }

    private static PointerButton? ButtonOf(PointerUpdateKind kind) => kind switch
    {
        PointerUpdateKind.LeftButtonPressed or PointerUpdateKind.LeftButtonReleased => PointerButton.Left,
        PointerUpdateKind.MiddleButtonPressed or PointerUpdateKind.MiddleButtonReleased => PointerButton.Middle,
        PointerUpdateKind.RightButtonPressed or PointerUpdateKind.RightButtonReleased => PointerButton.Right,
        _ => null,
    };

    private Point2D PlaceOf(PointerEventArgs e)
    {
        var at = e.GetPosition(this);
        return new Point2D(at.X, at.Y);
    }
}
