namespace Engraver.App.Tests.RealWindow;

/// <summary>A timer for polling a screen.</summary>
internal sealed class PollingTimer : IDisposable
{
    private readonly AutoResetEvent _due = new(initialState: false);
    private readonly Timer _timer;

    /// <param name="between">The interval.</param>
    public PollingTimer(TimeSpan between) => _timer = new Timer(_ => _due.Set(), null, between, between);

    /// <summary>Waits until the next poll is due.</summary>
    public void WaitForNext() => _due.WaitOne();

    public void Dispose()
    {
        using var ended = new ManualResetEvent(initialState: false);
        if (_timer.Dispose(ended)) ended.WaitOne(); // a tick that is due now still sets the event
        _due.Dispose();
    }
}
