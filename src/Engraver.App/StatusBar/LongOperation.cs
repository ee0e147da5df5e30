using Avalonia.Threading;
using Engraver.App.Desk;

namespace Engraver.App.StatusBar;

/// <summary>A long operation: a running command, or the planning of the job. Shown after a short delay to avoid flicker; a command that reports its
/// progress is shown immediately.</summary>
/// <param name="again">Called on the UI thread when it is time to show it.</param>
internal sealed class LongOperation(DesktopModel desk, Action again)
{
    private static readonly TimeSpan s_delay = TimeSpan.FromMilliseconds(400);

    private object? _operation;
    private long _since;
    private ITimer? _timer;

    public bool IsShown { get; private set; }

    /// <summary>0 to 1; null if unknown.</summary>
    public double? Fraction { get; private set; }

    public string Text { get; private set; } = "";

    /// <summary>Updates the state from what is running.</summary>
    public void Refresh()
    {
        var session = desk.Session;
        if (session.Progress.Fraction is { } read) Show(read, Texts.Text.Get("Status.Progress", read * 100.0));
        else if (desk is { Queue.IsBusy: true, IsMoving: false } && session.IsBusy && session.RunningCommand is { } command) ShowLater(command, null, Texts.Text.Get(session.IsEnding ? "Status.Cancelling" : "Status.Running", command));
        else if (session.Derivation.Progress.Stage is { } stage) ShowLater(session.Derivation, stage.Before, Texts.Text.Get(desk.IsMoving ? "Status.PlanningBeside" : "Status.Planning", stage.Name, stage.Before * 100.0));
        else Hide();
    }

    private void Show(double? fraction, string text) => (IsShown, Fraction, Text) = (true, fraction, text);

    private void ShowLater(object what, double? fraction, string text)
    {
        if (!Equals(what, _operation)) StartTimer(what);
        if (desk.Time.GetElapsedTime(_since) >= s_delay) Show(fraction, text);
        else IsShown = false;
    }

    private void StartTimer(object what)
    {
        (_operation, _since) = (what, desk.Time.GetTimestamp());
        _timer?.Dispose();
        _timer = desk.Time.CreateTimer(_ => Dispatcher.UIThread.Post(again, DispatcherPriority.Input), null, s_delay, Timeout.InfiniteTimeSpan);
    }

    private void Hide()
    {
        _timer?.Dispose();
        (_timer, _operation, IsShown, Fraction, Text) = (null, null, false, null, "");
    }
}
