using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace Engraver.App.Properties;

/// <summary>A list of properties. A field is accepted with Enter or when it loses the focus, and reverted with Esc.</summary>
public partial class PropertyLinesView : UserControl
{
    public static readonly StyledProperty<IReadOnlyList<PropertyLine>?> LinesProperty = AvaloniaProperty.Register<PropertyLinesView, IReadOnlyList<PropertyLine>?>(nameof(Lines));

    public PropertyLinesView()
    {
        InitializeComponent();
        AddHandler(KeyDownEvent, OnKey, RoutingStrategies.Tunnel);
        LineList.AddHandler(LostFocusEvent, OnFieldLostFocus, RoutingStrategies.Bubble);
    }

    public IReadOnlyList<PropertyLine>? Lines
    {
        get => GetValue(LinesProperty);
        set => SetValue(LinesProperty, value);
    }

    /// <summary>Enter and Esc in a field belong to the field, not to the window.</summary>
    public static bool Handles(object? source, Key key) => key is Key.Enter or Key.Escape && source is TextBox { DataContext: PropertyLine };

    private void OnKey(object? sender, KeyEventArgs e)
    {
        if (e.Source is not TextBox { DataContext: PropertyLine line }) return;
        if (e.Key == Key.Enter) line.Accept();
        else if (e.Key == Key.Escape) line.Revert();
        else return;
        e.Handled = true;
        TopLevel.GetTopLevel(this)?.FocusManager?.Focus(null);
    }

    private static void OnFieldLostFocus(object? sender, RoutedEventArgs e)
    {
        if (e.Source is TextBox { DataContext: PropertyLine line }) line.Accept();
    }
}
