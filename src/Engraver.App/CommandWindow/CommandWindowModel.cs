using System.Collections.ObjectModel;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;

namespace Engraver.App.CommandWindow;

/// <summary>The command window and its line: history, prompt with its options, the typed line, suggestions.</summary>
public sealed class CommandWindowModel : ObservableObject, IVisibilityAware
{
    private const int MaxLines = 5000;
    private readonly DesktopModel _desk;
    private readonly InputHistory _inputs = new();
    private PromptView _shown = PromptView.Idle;

    /// <summary>Identifies the prompt whose default is in the line.</summary>
    private object? _edited;
    private string _line = "";
    private IReadOnlyList<CommandSuggestion> _suggestions = [];
    private int _suggested = -1;
    private bool _isPageVisible;

    public CommandWindowModel(DesktopModel desk)
    {
        _desk = desk;
        Choose = new RelayCommand(option => _ = desk.Queue.EnterAsync(((Keyword)option!).Name));
        desk.Notifications.MessagesWritten += OnMessagesAdded;
        desk.Notifications.Changed += OnChanged;
    }

    public ObservableCollection<HistoryLine> History { get; } = [];

    /// <summary>The history is visible. While it is not, the command line shows the last message.</summary>
    public bool IsPageVisible
    {
        get => _isPageVisible;
        set => SetProperty(ref _isPageVisible, value);
    }

    /// <summary>The last message; null at the start.</summary>
    public HistoryLine? Last => History.LastOrDefault(line => line.Text.Trim().Length > 0);

    /// <summary>A click on an option of the prompt.</summary>
    public RelayCommand Choose { get; }

    /// <summary>Instruction and default without the options, which are shown beside it as buttons.</summary>
    public string Instruction => _desk.Queue.IsBusy && _desk.Prompt.Command is null ? Texts.Text.Get("Command." + WorkText(_desk.Session.Machine.Status.State)) : PromptLine.WithoutOptions(_desk.Prompt.Text);

    public IReadOnlyList<Keyword> Options => _desk.Prompt.Options;

    public bool HasOptions => Options.Count > 0;

    /// <summary>The typed text.</summary>
    public string Line
    {
        get => _line;
        set
        {
            if (!SetProperty(ref _line, value ?? "")) return;
            _desk.TypedLine = _line;
            Suggest();
        }
    }

    /// <summary>Completions of a command name; empty while a prompt requests something else.</summary>
    public IReadOnlyList<CommandSuggestion> Suggestions
    {
        get => _suggestions;
        private set
        {
            SetProperty(ref _suggestions, value);
            OnPropertyChanged(nameof(HasSuggestions));
        }
    }

    public bool HasSuggestions => _suggestions.Count > 0;

    /// <summary>Index of the suggestion that Tab takes; -1 for none.</summary>
    public int Suggested
    {
        get => _suggested;
        set => SetProperty(ref _suggested, value);
    }

    /// <summary>True if Space ends the input, as Enter does: except in an answer that may contain spaces, and in a path, which may be typed before the
    /// command has requested it.</summary>
    public bool SpaceSubmits => !_desk.Prompt.AllowsSpaces && !TypedFileName.IsPath(_line);

    /// <summary>Enter (or Space): passes the line to the command session.</summary>
    public void Submit()
    {
        var input = Line;
        _inputs.Add(input);
        Line = "";
        _ = _desk.Queue.TypeAsync(DirectDistance.Read(input, _desk.Session.DirectDistanceBase, _desk.Cursor));
    }

    /// <summary>Pasted text of several lines: complete lines are passed to the command session after the typed text; an incomplete last line stays in the
    /// command line.</summary>
    public void Paste(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var all = (Line + text).ReplaceLineEndings("\n");
        var end = all.LastIndexOf('\n');
        Line = all[(end + 1)..];
        _ = _desk.Queue.EnterLinesAsync(all[..(end + 1)]);
    }

    /// <summary>Takes the typed text from the line, for use elsewhere.</summary>
    public string TakeLine()
    {
        var line = Line;
        Line = "";
        return line;
    }

    public void Accept(CommandSuggestion suggestion)
    {
        var input = DisplayName(suggestion);
        Line = "";
        _inputs.Add(input);
        _ = _desk.Queue.TypeAsync(input);
    }

    /// <summary>Tab: the line becomes the next suggestion.</summary>
    public void Complete()
    {
        if (_suggestions.Count == 0) return;
        var (suggestions, next) = (_suggestions, (_suggested + 1) % _suggestions.Count);
        SetProperty(ref _line, DisplayName(suggestions[next]), nameof(Line));
        (Suggestions, Suggested) = (suggestions, next);
    }

    /// <summary>The last inputs, newest first, without commands that start motion: for a menu.</summary>
    public IReadOnlyList<string> Recent => [.. _inputs.Recent.Where(input => _desk.Session.Catalog.Find(_desk.Session.Aliases.Commands.GetValueOrDefault(input.ToUpperInvariant(), input)) is not { Info.StartsMotion: true })];

    /// <summary>Repeats a recent input.</summary>
    public void Repeat(string input)
    {
        Line = "";
        _inputs.Add(input);
        _ = _desk.Queue.TypeAsync(input);
    }

    public void Back() => Recall(_inputs.Back(Line));

    public void Forward() => Recall(_inputs.Forward(Line));

    /// <summary>Esc: first clears the typed text, then cancels the prompt.</summary>
    public void Cancel()
    {
        Line = "";
        _ = _desk.Queue.CancelAsync();
    }

    /// <summary>The running operation while there is no prompt, and how it is ended: Esc holds a running job, and does nothing to one that is braking or
    /// held.</summary>
    private static string WorkText(MachineState state) => state switch
    {
        MachineState.Running or MachineState.DryRun => "JobRunning",
        MachineState.Held => "JobHeld",
        MachineState.Holding or MachineState.Stopping => "JobStopping",
        _ => "Working",
    };

    /// <summary>The name of a suggested command, with the typed apostrophe before it, if any.</summary>
    private string DisplayName(CommandSuggestion suggestion) => (Line.StartsWith('\'') ? "'" : "") + suggestion.Command.Name;

    private void Recall(string line)
    {
        SetProperty(ref _line, line, nameof(Line));
        Suggestions = [];
    }

    private void Suggest()
    {
        var wanted = _desk.Prompt.Command is null || (_line.StartsWith('\'') && !_desk.Prompt.AllowsSpaces);
        Suggestions = wanted ? [.. _desk.Session.Suggest(_line).DistinctBy(suggestion => suggestion.Text)] : [];
        Suggested = -1;
    }

    /// <summary>Puts the default of a prompt that edits it into the empty line, once.</summary>
    private void EditDefault()
    {
        var typed = _desk.Prompt.EditsDefault ? _desk.Prompt.TypedGhost : null;
        if (Equals(typed, _edited)) return;
        _edited = typed;
        if (typed is not null && Line.Length == 0) Line = _desk.Prompt.Default ?? "";
    }

    private void OnMessagesAdded(IReadOnlyList<CommandMessage> messages)
    {
        foreach (var message in messages)
        {
            foreach (var line in HistoryLine.From(message)) History.Add(line);
        }

        while (History.Count > MaxLines) History.RemoveAt(0);
        OnPropertyChanged(nameof(Last));
    }

    private void OnChanged()
    {
        OnPropertyChanged(nameof(Instruction));
        EditDefault();
        if (ReferenceEquals(_shown.Options, _desk.Prompt.Options)) return;
        _shown = _desk.Prompt;
        OnPropertyChanged(nameof(Options));
        OnPropertyChanged(nameof(HasOptions));
    }
}
