using Avalonia;
using Avalonia.Controls;
using Avalonia.Interactivity;

namespace Engraver.App.HandMoves;

/// <summary>The Machine page.</summary>
public partial class HandMovesView : UserControl
{
    private Window? _window;

    public HandMovesView()
    {
        InitializeComponent();
        FastKey.AddHandler(PointerPressedEvent, (_, e) => SetFast(e.GetCurrentPoint(FastKey).Properties.IsLeftButtonPressed), RoutingStrategies.Tunnel, handledEventsToo: true);
        FastKey.AddHandler(PointerReleasedEvent, (_, _) => SetFast(false), RoutingStrategies.Tunnel, handledEventsToo: true);
        FastKey.PointerCaptureLost += (_, _) => SetFast(false);
    }

    private HandMovesModel? Model => DataContext as HandMovesModel;

    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        if (TopLevel.GetTopLevel(this) is not Window window) return;
        _window = window;
        window.Deactivated += OnWindowDeactivated;
    }

    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        SetFast(false);
        if (_window is { } window) window.Deactivated -= OnWindowDeactivated;
        base.OnDetachedFromVisualTree(e);
    }

    /// <summary>The rapid enable key is pressed or released; losing the pointer or the window releases it.</summary>
    private void SetFast(bool held)
    {
        if (Model is { } model) model.IsFast = held;
    }

    private void OnWindowDeactivated(object? sender, EventArgs e) => SetFast(false);

    private void OnOrigin(object? sender, RoutedEventArgs e)
    {
        if (sender is Button { DataContext: OriginRow origin }) Model?.ChooseOrigin(origin);
    }

    private void OnOutput(object? sender, RoutedEventArgs e)
    {
        if (sender is Button { DataContext: IoRow output }) Model?.SwitchOutput(output);
    }
}
