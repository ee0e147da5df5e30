using Engraver.SoftwarePlatform.Windows;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.Windows;

public sealed class SoftwareDispatcherTests : IDisposable
{
    private readonly ManualTimeProvider _time = new();
    private readonly SoftwareDispatcher _dispatcher;
    private readonly List<string> _done = [];

    public SoftwareDispatcherTests()
    {
        _dispatcher = new SoftwareDispatcher(_time);
        _dispatcher.Signaled += () => _done.Add("signal");
        _dispatcher.Timer += () => _done.Add("timer");
        _dispatcher.ReadyForBackgroundProcessing += () => _done.Add("background");
    }

    public void Dispose() => _dispatcher.Dispose();

    [Fact]
    public void Signals_come_before_timers_and_timers_before_background_work()
    {
        _dispatcher.RequestBackgroundProcessing();
        _dispatcher.UpdateTimer(0);
        _dispatcher.Signal();
        while (_dispatcher.RunOne())
        {
        }

        Assert.Equal(["signal", "timer", "background"], _done);
    }

    [Fact]
    public void A_timer_falls_due_when_the_clock_is_moved_and_once()
    {
        _dispatcher.UpdateTimer(100);
        _time.Advance(TimeSpan.FromMilliseconds(99));
        Assert.False(_dispatcher.RunOne());

        _time.Advance(TimeSpan.FromMilliseconds(1));
        Assert.True(_dispatcher.RunOne());
        Assert.False(_dispatcher.RunOne());
        Assert.Equal(["timer"], _done);
    }

    [Fact]
    public async Task A_waiting_loop_is_woken_by_a_signal_by_the_moved_clock_and_by_its_end()
    {
        using var ending = new CancellationTokenSource();
        var signalled = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var timed = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        _dispatcher.Signaled += () => signalled.SetResult();
        _dispatcher.Timer += () => timed.SetResult();
        var loop = Task.Factory.StartNew(() => _dispatcher.RunLoop(ending.Token), ending.Token, TaskCreationOptions.LongRunning, TaskScheduler.Default);

        _dispatcher.Signal();
        await signalled.Task;
        _dispatcher.UpdateTimer(_dispatcher.Now + 10);
        _time.Advance(TimeSpan.FromMilliseconds(10));
        await timed.Task;
        await ending.CancelAsync();
        await loop;

        Assert.Equal(["signal", "timer"], _done);
    }
}
