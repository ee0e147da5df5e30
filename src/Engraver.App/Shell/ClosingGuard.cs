using Avalonia.Controls;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Workbench.Commands;

namespace Engraver.App.Shell;

/// <summary>Closing the window ends a job and loses edits that are in no file: the first request to close is answered with a warning, the second one is carried out.</summary>
internal sealed class ClosingGuard
{
    private readonly DesktopModel _desk;
    private bool _warnedOfJob;
    private Drawing? _warnedOf;

    public ClosingGuard(DesktopModel desk)
    {
        _desk = desk;
        desk.Changed += () => _warnedOfJob &= desk.IsMoving;
    }

    /// <summary>Tells in the history why the window stays open.</summary>
    /// <returns>True when it has to stay this time.</returns>
    public bool Holds(WindowCloseReason reason)
    {
        if (reason is WindowCloseReason.ApplicationShutdown or WindowCloseReason.OSShutdown) return false;
        var state = _desk.Session.Document.Current;
        var warnsOfJob = _desk.IsMoving && !_warnedOfJob;
        var warnsOfEdits = _desk.Session.Document.IsEdited && !ReferenceEquals(state.Edition, _warnedOf);
        if (warnsOfJob) _desk.Tell(MessageKind.Warning, Text.Get("Window.JobRuns"));
        if (warnsOfEdits) _desk.Tell(MessageKind.Warning, Text.Get("Window.NotSaved", Path.GetFileName(_desk.Session.Document.FilePath)));
        (_warnedOfJob, _warnedOf) = (_desk.IsMoving, state.Edition);
        return warnsOfJob || warnsOfEdits;
    }
}
