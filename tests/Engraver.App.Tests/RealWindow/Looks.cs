namespace Engraver.App.Tests.RealWindow;

/// <summary>The moments at which a screen is looked at.</summary>
internal sealed class Looks : IDisposable
{
    private readonly AutoResetEvent _due = new(initialState: false);
    private readonly Timer _timer;

    /// <param name="between">From one look to the next.</param>
    public Looks(TimeSpan between) => _timer = new Timer(_ => _due.Set(), null, between, between);

    /// <summary>Ends when the next look is due.</summary>
    public void Next() => _due.WaitOne();

    public void Dispose()
    {
        using var ended = new ManualResetEvent(initialState: false);
        if (_timer.Dispose(ended)) ended.WaitOne(); // a look that is due just now still sets the event
        _due.Dispose();
    }
}
