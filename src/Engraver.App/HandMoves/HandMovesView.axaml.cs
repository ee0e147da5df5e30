using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace Engraver.App.HandMoves;

/// <summary>The Machine page.</summary>
public partial class HandMovesView : UserControl
{
    private Window? _window;

    public HandMovesView()
    {
        InitializeComponent();
        FastKey.AddHandler(PointerPressedEvent, (_, e) => HoldFast(e.GetCurrentPoint(FastKey).Properties.IsLeftButtonPressed), RoutingStrategies.Tunnel, handledEventsToo: true);
        FastKey.AddHandler(PointerReleasedEvent, (_, _) => HoldFast(false), RoutingStrategies.Tunnel, handledEventsToo: true);
        FastKey.PointerCaptureLost += (_, _) => HoldFast(false);
    }

    private HandMovesModel? Model => DataContext as HandMovesModel;

    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        if (TopLevel.GetTopLevel(this) is not Window window) return;
        _window = window;
        window.Deactivated += OnWindowLost;
    }

    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        HoldFast(false);
        if (_window is { } window) window.Deactivated -= OnWindowLost;
        base.OnDetachedFromVisualTree(e);
    }

    /// <summary>The rapid enable key is pressed or released; losing the pointer or the window releases it.</summary>
    private void HoldFast(bool held)
    {
        if (Model is { } model) model.IsFast = held;
    }

    private void OnWindowLost(object? sender, EventArgs e) => HoldFast(false);

    private void OnOrigin(object? sender, RoutedEventArgs e)
    {
        if (sender is Button { DataContext: OriginRow origin }) Model?.Choose(origin);
    }

    private void OnOutput(object? sender, RoutedEventArgs e)
    {
        if (sender is Button { DataContext: LineRow output }) Model?.Switch(output);
    }
}
