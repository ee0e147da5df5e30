using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Layout;

namespace Engraver.SoftwarePlatform.Tests;

/// <summary>One of each kind of control that users operate.</summary>
internal sealed class DemoWindow : Window
{
    public DemoWindow()
    {
        Title = "Software platform: größe ✓";
        (Width, Height) = (800, 520);
        Counter.Click += (_, _) => Counter.Content = $"Pressed {++Presses}";
        ToolTip.SetTip(Counter, "Counts how often it was pressed");
        Choice.ItemsSource = new[] { "first", "second", "third" };
        Choice.SelectedIndex = 0;
        File.ItemsSource = new[] { new MenuItem { Header = "_Open" }, new MenuItem { Header = "_Close" } };
        Rows.ItemsSource = Enumerable.Range(1, 200).Select(row => $"Row {row}").ToArray();
        DragDrop.SetAllowDrop(this, true);
        Content = Arranged();
    }

    public int Presses { get; private set; }

    public Button Counter { get; } = new() { Content = "Press me" };

    public TextBox Entry { get; } = new() { Width = 320, PlaceholderText = "Type here" };

    public ComboBox Choice { get; } = new() { Width = 160 };

    public MenuItem File { get; } = new() { Header = "_File" };

    public Slider Feed { get; } = new() { Width = 320, Maximum = 100 };

    public ListBox Rows { get; } = new() { Width = 320, Height = 220 };

    /// <summary>The middle of a control, in the window's units.</summary>
    public Point Middle(Control control) => control.TranslatePoint(new Point(control.Bounds.Width / 2, control.Bounds.Height / 2), this)
        ?? throw new InvalidOperationException("The control is not in this window.");

    private DockPanel Arranged()
    {
        var menu = new Menu { ItemsSource = new[] { File } };
        DockPanel.SetDock(menu, Dock.Top);
        var row = new StackPanel { Orientation = Orientation.Horizontal, Spacing = 12, Children = { Counter, Choice } };
        var column = new StackPanel { Spacing = 12, Margin = new Thickness(16), HorizontalAlignment = HorizontalAlignment.Left, Children = { row, Entry, Feed, Rows } };
        return new DockPanel { Children = { menu, column } };
    }
}
