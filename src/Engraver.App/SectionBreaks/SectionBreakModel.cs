using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.MachineStrip;
using Engraver.App.Texts;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.App.SectionBreaks;

/// <summary>The question at a change of the tool or a stop between repeats: what the operator does, and whether the job continues. It is gone with the link,
/// the drawing and its settings; the rest of the job is then resumed by its journal.</summary>
public sealed class SectionBreakModel : ObservableObject
{
    /// <summary>A click that was meant for what was there before the panel does not continue the job.</summary>
    public static readonly TimeSpan Guard = TimeSpan.FromSeconds(1);

    private readonly DesktopModel _desk;

    /// <summary>The journal of the job that is not continued here.</summary>
    private string? _left;

    /// <summary>The journal of the job about which is asked; null while nothing is asked.</summary>
    private string? _asked;
    private bool _isGuarded;

    public SectionBreakModel(DesktopModel desk)
    {
        _desk = desk;
        Continue = new RelayCommand(ContinueNow, () => Reason is null);
        Stop = new RelayCommand(Leave);
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public bool IsOpen => _asked is not null;

    /// <summary>How far the job is.</summary>
    public string Title => Break is { } at ? Text.Get("SectionBreak.Title", at.Ended.Number, at.Ended.Count) : "";

    /// <summary>What the operator does before the job continues.</summary>
    public string Sentence => Break switch
    {
        null => "",
        { IsToolChange: false } at => Text.Get("SectionBreak.CheckWork", at.NextText),
        { IsHeightSet: true } at => Text.Get("SectionBreak.HeightIsSet", at.NextText),
        { } at when at.NeedsHeight(_desk.Session.Machine.Profile) => Text.Get("SectionBreak.ChangeTool", at.Ended.Tool.Tool.Title, at.NextText),
        { } at => Text.Get("SectionBreak.ChangeToolFlat", at.Ended.Tool.Tool.Title, at.NextText),
    };

    /// <summary>What continuing does; while it is not possible, the reason and what to do.</summary>
    public string ContinueTip => KeyReasons.TipOf(Reason, "SectionBreak.ContinueTip", Status);

    /// <summary>Passes the checks of ARM and runs the rest. Never by a key.</summary>
    public RelayCommand Continue { get; }

    /// <summary>Leaves the job as it is: ARM and START cut the rest later.</summary>
    public RelayCommand Stop { get; }

    private MachineStatus Status => _desk.Session.Machine.Status;

    private JobPart? Part => _desk.Session.Machine.Runs.Part;

    private SectionBreak? Break => Part?.Break;

    /// <summary>Why the job cannot be continued now, as a key of <see cref="KeyReasons"/>; null: it can.</summary>
    private string? Reason => _desk.Queue.IsBusy || _desk.Prompt.Command is not null ? "CommandActive" : _isGuarded ? "JustAsked" : Status.State == MachineState.Armed ? null : KeyReasons.Arm(Status);

    private void Refresh()
    {
        var (status, journal) = (Status, Break is null ? null : Part!.Request.Journal);
        if (journal is not null && (status.State is MachineState.Offline || status.IsLinkLost)) _left = journal;
        var asked = journal == _left || status.State.IsJob() ? null : journal;
        if (asked is null && _asked is null) return;
        if (asked is not null && asked != _asked) _ = GuardAsync();
        _asked = asked;
        OnPropertyChanged(null);
        Continue.RaiseCanExecuteChanged();
    }

    /// <summary>A second click while the first one is at work does nothing: it would continue after the next section.</summary>
    private void ContinueNow()
    {
        if (Reason is null) _ = _desk.Queue.RunAsync("CNCCONTINUE", "Yes");
    }

    private async Task GuardAsync()
    {
        _isGuarded = true;
        await Task.Delay(Guard, _desk.Time);
        _isGuarded = false;
        Refresh();
    }

    private void Leave()
    {
        _left = _asked;
        Refresh();
    }
}
