using Avalonia.Controls;
using Engraver.App.Desk;
using Engraver.App.FileDialogs;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Workbench.Commands;

namespace Engraver.App.Shell;

/// <summary>Closing the window ends a job and loses unsaved edits. While a job runs the first request to close shows a warning, the second one closes;
/// edits are asked about each time until the operator has answered.</summary>
internal sealed class ClosingGuard
{
    private readonly DesktopModel _desk;
    private readonly FileQuestions _files;
    private readonly Action _close;
    private bool _warnedOfJob;

    /// <summary>The edits that may be discarded; null: the operator has not answered.</summary>
    private Drawing? _discardableEdits;
    private bool _isAsking;

    /// <param name="close">Requests closing again, after the edits are saved or may be lost.</param>
    public ClosingGuard(DesktopModel desk, FileQuestions files, Action close)
    {
        (_desk, _files, _close) = (desk, files, close);
        desk.Notifications.Changed += () => _warnedOfJob &= desk.IsMoving;
    }

    /// <summary>Reports in the history why the window stays open, or asks whether edits are saved first; a request to close while that question is open has
    /// no effect.</summary>
    /// <returns>True if the window has to stay open this time.</returns>
    public bool PreventsClosing(WindowCloseReason reason)
    {
        if (reason is WindowCloseReason.ApplicationShutdown or WindowCloseReason.OSShutdown) return false;
        if (_isAsking) return true;
        var warnsOfJob = _desk.IsMoving && !_warnedOfJob;
        _warnedOfJob = _desk.IsMoving;
        if (warnsOfJob)
        {
            _desk.Notifications.Write(MessageKind.Warning, Text.Get("Window.CloseWhileMoving"));
            return true;
        }

        if (!_desk.Session.Document.IsEdited || ReferenceEquals(_desk.Session.Document.Current.Edition, _discardableEdits)) return false;
        _ = AskAsync();
        return true;
    }

    private async Task AskAsync()
    {
        var edits = _desk.Session.Document.Current.Edition;
        _isAsking = true;
        bool may;
        try
        {
            may = await _files.ConfirmCloseAsync();
        }
        finally
        {
            _isAsking = false;
        }

        if (!may) return;
        _discardableEdits = edits;
        _close();
    }
}
