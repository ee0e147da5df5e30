using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Interactivity;
using Engraver.Workbench.Commands;

namespace Engraver.App.CommandWindow;

/// <summary>The command line, in sight whatever page is in front. Typing anywhere in the shell arrives at <see cref="Type"/>.</summary>
public partial class CommandLineView : UserControl
{
    /// <summary>How many of the suggestions are seen at once; the rest is scrolled to.</summary>
    private const int SuggestionsSeen = 12;

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

    /// <summary>Text that was typed somewhere else goes into the line; Space may end it.</summary>
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

    /// <summary>Ctrl+V: text goes into the line as it would be typed, several lines go to the commands.</summary>
    public async Task PasteAsync()
    {
        var clipboard = TopLevel.GetTopLevel(this)?.Clipboard;
        if (clipboard is null || await clipboard.TryGetTextAsync() is not { Length: > 0 } text) return;
        var line = text.TrimEnd('\r', '\n'); // a single line, with its line end or without, is typed and not run: a file name may hold spaces
        if (line.AsSpan().ContainsAny('\r', '\n'))
        {
            Model.Paste(text);
            LineBox.CaretIndex = Model.Line.Length;
            return;
        }

        LineBox.Focus();
        LineBox.SelectedText = line;
    }

    /// <summary>A key that was pressed somewhere else.</summary>
    /// <returns>True when it was one for the command line.</returns>
    public bool Press(Key key)
    {
        switch (key)
        {
            case Key.Enter: Model.Submit(); break;
            case Key.Up when Model.HasSuggestions: Model.Suggested = Math.Max(0, Model.Suggested - 1); break;
            case Key.Down when Model.HasSuggestions: Model.Suggested = Math.Min(Model.Suggestions.Count - 1, Model.Suggested + 1); break;
            case Key.PageUp when Model.HasSuggestions: Model.Suggested = Math.Max(0, Model.Suggested - SuggestionsSeen); break;
            case Key.PageDown when Model.HasSuggestions: Model.Suggested = Math.Min(Model.Suggestions.Count - 1, Model.Suggested + SuggestionsSeen); break;
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
        if (e.Key == Key.Enter && Model is { HasSuggestions: true, Suggested: >= 0 and var chosen }) Model.Take(Model.Suggestions[chosen]);
        else if (e.KeyModifiers != KeyModifiers.None || !Press(e.Key)) return;
        e.Handled = true;
    }

    private void OnLineText(object? sender, TextInputEventArgs e)
    {
        if (e.Text != " " || !Model.SpaceSubmits) return;
        Model.Submit();
        e.Handled = true;
    }

    /// <summary>Takes over pasting from the text box, which would take the first line and drop the others.</summary>
    private void OnPasting(object? sender, RoutedEventArgs e)
    {
        e.Handled = true;
        _ = PasteAsync();
    }

    private void OnSuggestionClick(object? sender, PointerReleasedEventArgs e)
    {
        if ((e.Source as Control)?.DataContext is CommandSuggestion suggestion) Model.Take(suggestion);
    }
}
