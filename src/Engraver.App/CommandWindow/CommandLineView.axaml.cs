using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Interactivity;
using Engraver.Workbench.Commands;

namespace Engraver.App.CommandWindow;

/// <summary>The command line, visible whatever page is in front. Text typed anywhere in the shell arrives at <see cref="Type"/>.</summary>
public partial class CommandLineView : UserControl
{
    /// <summary>Maximum number of visible suggestions; the rest are scrolled.</summary>
    private const int MaxVisibleSuggestions = 12;

    public CommandLineView()
    {
        InitializeComponent();
        LineBox.AddHandler(KeyDownEvent, OnLineKey, RoutingStrategies.Tunnel);
        LineBox.AddHandler(TextInputEvent, OnLineText, RoutingStrategies.Tunnel);
        LineBox.PastingFromClipboard += OnPasting;
        SuggestionList.AddHandler(PointerReleasedEvent, OnSuggestionClick, RoutingStrategies.Tunnel | RoutingStrategies.Bubble, handledEventsToo: true);
        SuggestionList.SelectionChanged += (_, _) =>
        {
            if (SuggestionList.SelectedIndex >= 0) SuggestionList.ScrollIntoView(SuggestionList.SelectedIndex);
        };
    }

    private CommandWindowModel Model => (CommandWindowModel)DataContext!;

    /// <summary>Text typed elsewhere is inserted into the line; Space may end it.</summary>
    public void Type(string text)
    {
        if (text == " " && Model.SpaceSubmits)
        {
            Model.Submit();
            return;
        }

        Model.Line += text;
        LineBox.Focus();
        LineBox.CaretIndex = Model.Line.Length;
    }

    /// <summary>Ctrl+V: a single line is inserted as if typed, several lines are passed to the commands.</summary>
    public async Task PasteAsync()
    {
        var clipboard = TopLevel.GetTopLevel(this)?.Clipboard;
        if (clipboard is null || await clipboard.TryGetTextAsync() is not { Length: > 0 } text) return;
        var line = text.TrimEnd('\r', '\n'); // a single line, with or without its line end, is inserted and not run, because a file name may contain spaces
        if (line.AsSpan().ContainsAny('\r', '\n'))
        {
            Model.Paste(text);
            LineBox.CaretIndex = Model.Line.Length;
            return;
        }

        LineBox.Focus();
        LineBox.SelectedText = line;
    }

    /// <summary>A key that was pressed elsewhere.</summary>
    /// <returns>True if the command line handled it.</returns>
    public bool Press(Key key)
    {
        switch (key)
        {
            case Key.Enter: Model.Submit(); break;
            case Key.Up when Model.HasSuggestions: Model.Suggested = Math.Max(0, Model.Suggested - 1); break;
            case Key.Down when Model.HasSuggestions: Model.Suggested = Math.Min(Model.Suggestions.Count - 1, Model.Suggested + 1); break;
            case Key.PageUp when Model.HasSuggestions: Model.Suggested = Math.Max(0, Model.Suggested - MaxVisibleSuggestions); break;
            case Key.PageDown when Model.HasSuggestions: Model.Suggested = Math.Min(Model.Suggestions.Count - 1, Model.Suggested + MaxVisibleSuggestions); break;
            case Key.Up: Model.Back(); break;
            case Key.Down: Model.Forward(); break;
            case Key.Tab when Model.HasSuggestions: Model.Complete(); break;
            default: return false;
        }

        LineBox.CaretIndex = Model.Line.Length;
        return true;
    }

    private void OnLineKey(object? sender, KeyEventArgs e)
    {
        if (e.Key == Key.Enter && Model is { HasSuggestions: true, Suggested: >= 0 and var chosen }) Model.Accept(Model.Suggestions[chosen]);
        else if (e.KeyModifiers != KeyModifiers.None || !Press(e.Key)) return;
        e.Handled = true;
    }

    private void OnLineText(object? sender, TextInputEventArgs e)
    {
        if (e.Text != " " || !Model.SpaceSubmits) return;
        Model.Submit();
        e.Handled = true;
    }

    /// <summary>Replaces the pasting of the text box, which would take the first line and drop the others.</summary>
    private void OnPasting(object? sender, RoutedEventArgs e)
    {
        e.Handled = true;
        _ = PasteAsync();
    }

    private void OnSuggestionClick(object? sender, PointerReleasedEventArgs e)
    {
        if ((e.Source as Control)?.DataContext is CommandSuggestion suggestion) Model.Accept(suggestion);
    }
}
