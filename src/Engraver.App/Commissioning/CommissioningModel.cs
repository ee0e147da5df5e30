using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.App.Commissioning;

/// <summary>The commissioning page: its steps, their state, and buttons for the answers, which are entered into the conversation of
/// CNCCOMMISSION.</summary>
public sealed class CommissioningModel : ObservableObject
{
    private const string Command = "CNCCOMMISSION";
    private readonly DesktopModel _desk;
    private IReadOnlyList<CommissioningRow> _steps = [];
    private IReadOnlyList<Keyword> _answers = [];

    public CommissioningModel(DesktopModel desk)
    {
        _desk = desk;
        Start = new RelayCommand(() => _ = desk.Queue.RunAsync(Command), () => desk.Session.Machine.Connection.Description is not null && !desk.IsMoving && !IsRunning);
        Abort = new RelayCommand(() => _ = desk.Queue.CancelAsync(), () => IsRunning);
        Answer = new RelayCommand(option => _ = desk.Queue.EnterAsync(((Keyword)option!).Name), () => IsAsked);
        KeepDefault = new RelayCommand(() => _ = desk.Queue.EnterAsync(""), () => IsAsked);
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public RelayCommand Start { get; }

    public RelayCommand Abort { get; }

    /// <summary>A click on one of the answers.</summary>
    public RelayCommand Answer { get; }

    /// <summary>Enter alone: keeps the present value.</summary>
    public RelayCommand KeepDefault { get; }

    public IReadOnlyList<CommissioningRow> Steps
    {
        get => _steps;
        private set => SetProperty(ref _steps, value);
    }

    public bool IsRunning => _desk.Session.Commissioning.IsRunning;

    /// <summary>The question without its options; empty while there is none.</summary>
    public string Question => IsAsked ? PromptLine.WithoutOptions(_desk.Prompt.Text) : IsRunning ? Text.Get("Command.Working") : "";

    public IReadOnlyList<Keyword> Answers
    {
        get => _answers;
        private set => SetProperty(ref _answers, value);
    }

    /// <summary>Enter accepts a value that is not an option.</summary>
    public bool CanKeep => IsAsked && _desk.Prompt.Default is { Length: > 0 } standard && _desk.Prompt.Options.All(option => option.Name != standard);

    public string KeepText => Text.Get("Commissioning.Keep", _desk.Prompt.Default ?? "");

    /// <summary>The answer is a value, which is typed.</summary>
    public bool IsTyped => IsAsked && (CanKeep || _desk.Prompt.Options.Count == 0);

    private bool IsAsked => IsRunning && _desk.Prompt.Command == Command;

    private void Refresh()
    {
        IReadOnlyList<CommissioningRow> steps = [.. _desk.Session.Commissioning.Steps.Select(CommissioningRow.Of)];
        if (!steps.SequenceEqual(Steps)) Steps = steps;
        var answers = IsAsked ? _desk.Prompt.Options : [];
        if (!answers.SequenceEqual(Answers)) Answers = answers;
        OnPropertyChanged(null);
        foreach (var command in new[] { Start, Abort, Answer, KeepDefault }) command.RaiseCanExecuteChanged();
    }
}

/// <summary>A step and its state, in words.</summary>
public sealed record CommissioningRow(string Title, string State, bool IsCurrent)
{
    public static CommissioningRow Of(CommissioningStepView step)
    {
        ArgumentNullException.ThrowIfNull(step);
        var state = step.State switch
        {
            CommissioningState.InProgress => Text.Get("Commissioning.InProgress"),
            CommissioningState.Done => Text.Get("Commissioning.Done"),
            CommissioningState.Skipped => Text.Get("Commissioning.Skipped"),
            CommissioningState.Unfinished => Text.Get("Commissioning.Unfinished"),
            _ => "",
        };
        return new CommissioningRow(Text.Get("Commissioning.Row", step.Number, step.Name), state, step.State == CommissioningState.InProgress);
    }
}
