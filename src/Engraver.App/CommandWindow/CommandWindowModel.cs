using System.Collections.ObjectModel;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;

namespace Engraver.App.CommandWindow;

/// <summary>The command window and its line: history, prompt with its options, the typed line, suggestions.</summary>
public sealed class CommandWindowModel : Observable, ISeen
{
    private const int MostLines = 5000;
    private readonly DesktopModel _desk;
    private readonly InputHistory _inputs = new();
    private PromptView _shown = PromptView.Idle;
    private string _line = "";
    private IReadOnlyList<CommandSuggestion> _suggestions = [];
    private int _suggested = -1;
    private bool _isSeen;

    public CommandWindowModel(DesktopModel desk)
    {
        _desk = desk;
        Choose = new Act(option => _ = desk.Queue.EnterAsync(((Keyword)option!).Name));
        desk.Notifications.Said += OnSaid;
        desk.Notifications.Changed += OnChanged;
    }

    public ObservableCollection<HistoryLine> History { get; } = [];

    /// <summary>The history is visible. While it is not, the command line shows the last message.</summary>
    public bool IsSeen
    {
        get => _isSeen;
        set => Set(ref _isSeen, value);
    }

    /// <summary>The last message; null at the start.</summary>
    public HistoryLine? Last => History.LastOrDefault(line => line.Text.Trim().Length > 0);

    /// <summary>A click on an option of the prompt.</summary>
    public Act Choose { get; }

    /// <summary>Instruction and default without the options, which are shown beside it as buttons.</summary>
    public string Instruction => _desk.Queue.IsBusy && _desk.Prompt.Command is null ? Texts.Text.Get("Command." + Work(_desk.Session.Machine.Status.State)) : PromptLine.WithoutOptions(_desk.Prompt.Text);

    public IReadOnlyList<Keyword> Options => _desk.Prompt.Options;

    public bool HasOptions => Options.Count > 0;

    /// <summary>The typed text.</summary>
    public string Line
    {
        get => _line;
        set
        {
            if (!Set(ref _line, value ?? "")) return;
            Suggest();
        }
    }

    /// <summary>Completions of a command name; empty while a prompt requests something else.</summary>
    public IReadOnlyList<CommandSuggestion> Suggestions
    {
        get => _suggestions;
        private set
        {
            Set(ref _suggestions, value);
            Tell(nameof(HasSuggestions));
        }
    }

    public bool HasSuggestions => _suggestions.Count > 0;

    /// <summary>Index of the suggestion that Tab takes; -1 for none.</summary>
    public int Suggested
    {
        get => _suggested;
        set => Set(ref _suggested, value);
    }

    /// <summary>True if Space ends the input, as Enter does: except in an answer that may contain spaces, and in a path, which may be typed before the
    /// command has requested it.</summary>
    public bool SpaceSubmits => !_desk.Prompt.TakesSpaces && !TypedFileName.IsPath(_line);

    /// <summary>Enter (or Space): passes the line to the command session.</summary>
    public void Submit()
    {
        var input = Line;
        _inputs.Add(input);
        Line = "";
        _ = _desk.Queue.TypeAsync(DirectDistance.Read(input, _desk.Session.DistanceFrom, _desk.Cursor));
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

    public void Take(CommandSuggestion suggestion)
    {
        var input = Named(suggestion);
        Line = "";
        _inputs.Add(input);
        _ = _desk.Queue.TypeAsync(input);
    }

    /// <summary>Tab: the line becomes the next suggestion.</summary>
    public void Complete()
    {
        if (_suggestions.Count == 0) return;
        var (suggestions, next) = (_suggestions, (_suggested + 1) % _suggestions.Count);
        Set(ref _line, Named(suggestions[next]), nameof(Line));
        (Suggestions, Suggested) = (suggestions, next);
    }

    /// <summary>The last inputs, newest first, without commands that start motion: for a menu.</summary>
    public IReadOnlyList<string> Recent => [.. _inputs.Recent.Where(input => _desk.Session.Catalog.Find(_desk.Session.Aliases.Commands.GetValueOrDefault(input.ToUpperInvariant(), input)) is not { Info.StartsMotion: true })];

    /// <summary>Repeats a recent input.</summary>
    public void Again(string input)
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
    private static string Work(MachineState state) => state switch
    {
        MachineState.Running or MachineState.DryRun => "JobRunning",
        MachineState.Held => "JobHeld",
        MachineState.Holding or MachineState.Stopping => "JobStopping",
        _ => "Working",
    };

    /// <summary>The name of a suggested command, with the typed apostrophe before it, if any.</summary>
    private string Named(CommandSuggestion suggestion) => (Line.StartsWith('\'') ? "'" : "") + suggestion.Command.Name;

    private void Recall(string line)
    {
        Set(ref _line, line, nameof(Line));
        Suggestions = [];
    }

    private void Suggest()
    {
        var wanted = _desk.Prompt.Command is null || (_line.StartsWith('\'') && !_desk.Prompt.TakesSpaces);
        Suggestions = wanted ? [.. _desk.Session.Suggest(_line).DistinctBy(suggestion => suggestion.Text)] : [];
        Suggested = -1;
    }

    private void OnSaid(IReadOnlyList<CommandMessage> messages)
    {
        foreach (var message in messages)
        {
            foreach (var line in HistoryLine.From(message)) History.Add(line);
        }

        while (History.Count > MostLines) History.RemoveAt(0);
        Tell(nameof(Last));
    }

    private void OnChanged()
    {
        Tell(nameof(Instruction));
        if (ReferenceEquals(_shown.Options, _desk.Prompt.Options)) return;
        _shown = _desk.Prompt;
        Tell(nameof(Options));
        Tell(nameof(HasOptions));
    }
}
