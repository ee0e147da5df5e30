using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Layout;
using Avalonia.Threading;
using Engraver.App.Texts;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Machines;

namespace Engraver.App.HandMoves;

/// <summary>The jog pad: a press moves, a release stops; so do a lost focus, a lost pointer and a window that closes or is deactivated. Arrow keys belong
/// to the pad only while it has the focus.</summary>
public sealed class JogPad : UserControl
{
    private static readonly (string Name, JogVelocity Way, int Row, int Column)[] s_cells =
    [
        ("↖", new JogVelocity(-1, 1), 0, 0), ("YPlus", new JogVelocity(0, 1), 0, 1), ("↗", new JogVelocity(1, 1), 0, 2), ("ZPlus", new JogVelocity(0, 0, 1), 0, 3),
        ("XMinus", new JogVelocity(-1, 0), 1, 0), ("XPlus", new JogVelocity(1, 0), 1, 2),
        ("↙", new JogVelocity(-1, -1), 2, 0), ("YMinus", new JogVelocity(0, -1), 2, 1), ("↘", new JogVelocity(1, -1), 2, 2), ("ZMinus", new JogVelocity(0, 0, -1), 2, 3),
    ];

    private ITimer? _heartbeat;
    private Window? _window;
    private Key? _key;
    private bool _shift;

    public JogPad()
    {
        Focusable = true;
        Content = Cells();
        AddHandler(PointerPressedEvent, OnPadPressed, RoutingStrategies.Tunnel);
        AddHandler(PointerReleasedEvent, (_, _) => Release(), RoutingStrategies.Tunnel, handledEventsToo: true);
        PointerCaptureLost += (_, _) => Release();
        LostFocus += (_, _) => Release();
        GotFocus += (_, _) => Model?.PrepareJog();
    }

    private HandMovesModel? Model => DataContext as HandMovesModel;

    /// <summary>The keys that jog while the pad has the focus; all others go to the command line.</summary>
    public static JogVelocity? DirectionOf(Key key) => key switch
    {
        Key.Left => new JogVelocity(-1, 0),
        Key.Right => new JogVelocity(1, 0),
        Key.Up => new JogVelocity(0, 1),
        Key.Down => new JogVelocity(0, -1),
        Key.PageUp => new JogVelocity(0, 0, 1),
        Key.PageDown => new JogVelocity(0, 0, -1),
        _ => null,
    };

    /// <summary>Whether the pad handles a key; the window asks this before all other controls.</summary>
    public static bool Handles(object? source, Key key) => source is JogPad && (DirectionOf(key) is not null || key is Key.LeftShift or Key.RightShift);

    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        if (TopLevel.GetTopLevel(this) is not Window window) return;
        _window = window;
        window.Deactivated += OnWindowDeactivated;
        window.Closing += OnWindowClosing;
    }

    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        Release();
        if (_window is { } window)
        {
            window.Deactivated -= OnWindowDeactivated;
            window.Closing -= OnWindowClosing;
        }

        base.OnDetachedFromVisualTree(e);
    }

    protected override void OnKeyDown(KeyEventArgs e)
    {
        base.OnKeyDown(e);
        _shift = e.KeyModifiers.HasFlag(KeyModifiers.Shift) || e.Key is Key.LeftShift or Key.RightShift;
        if (DirectionOf(e.Key) is not { } way) return;
        e.Handled = true;
        if (_key is not null) return; // keyboard repeat
        if (way.Z != 0.0 && Model is { HasZ: false }) return;
        _key = e.Key;
        Press(way);
    }

    protected override void OnKeyUp(KeyEventArgs e)
    {
        base.OnKeyUp(e);
        if (e.Key is Key.LeftShift or Key.RightShift) _shift = false;
        if (e.Key != _key) return;
        Release();
        e.Handled = true;
    }

    private Grid Cells()
    {
        var grid = new Grid { RowDefinitions = new RowDefinitions("36,36,36"), ColumnDefinitions = new ColumnDefinitions("42,42,42,52") };
        foreach (var (name, way, row, column) in s_cells)
        {
            var cell = new Border
            {
                Tag = way,
                Margin = new Thickness(column == 3 ? 12 : 1, 1, 1, 1),
                CornerRadius = new CornerRadius(3),
                BorderThickness = new Thickness(1),
                Child = new TextBlock { Text = name.Length == 1 ? name : Text.Get("Pad." + name), HorizontalAlignment = HorizontalAlignment.Center, VerticalAlignment = VerticalAlignment.Center },
            };
            cell.Bind(Border.BackgroundProperty, this.GetResourceObservable("ChromeBrush"));
            cell.Bind(Border.BorderBrushProperty, this.GetResourceObservable("LineBrush"));
            if (way.Z != 0.0) cell.Bind(IsVisibleProperty, new Avalonia.Data.Binding(nameof(HandMovesModel.HasZ)));
            Grid.SetRow(cell, row);
            Grid.SetColumn(cell, column);
            grid.Children.Add(cell);
        }

        return grid;
    }

    private void OnPadPressed(object? sender, PointerPressedEventArgs e)
    {
        Focus();
        if (!e.GetCurrentPoint(this).Properties.IsLeftButtonPressed || CellAt(e.Source) is not { } way) return;
        _shift = e.KeyModifiers.HasFlag(KeyModifiers.Shift);
        e.Pointer.Capture(this);
        e.Handled = true;
        Press(way);
    }

    private static JogVelocity? CellAt(object? source) => source switch
    {
        Border { Tag: JogVelocity way } => way,
        TextBlock { Parent: Border { Tag: JogVelocity way } } => way,
        _ => null,
    };

    private void Press(JogVelocity way)
    {
        if (Model is not { } model) return;
        model.Press(way, _shift);
        _heartbeat?.Dispose();
        _heartbeat = model.Time.CreateTimer(_ => Dispatcher.UIThread.Post(OnHeartbeat, DispatcherPriority.Background), null, OperatorPresence.SignInterval, OperatorPresence.SignInterval);
    }

    private void Release()
    {
        _key = null;
        _heartbeat?.Dispose();
        _heartbeat = null;
        Model?.Release();
    }

    /// <summary>The window responds: called at a priority below the rest of its work.</summary>
    private void OnHeartbeat()
    {
        if (_heartbeat is not null) Model?.KeepJogging(_shift);
    }

    private void OnWindowDeactivated(object? sender, EventArgs e) => Release();

    private void OnWindowClosing(object? sender, WindowClosingEventArgs e) => Release();
}
