using Engraver.Cli.Terminals;

namespace Engraver.Cli.Tests.Terminals;

public class LineQueueTests
{
    /// <summary>A running job writes to the terminal on its own thread, whose heartbeat must not be delayed.</summary>
    [Fact]
    public async Task A_terminal_that_takes_nothing_holds_up_nobody_who_speaks_to_it()
    {
        using var taken = new ManualResetEventSlim();
        var written = new List<string>();
        var queue = new LineQueue(line =>
        {
            taken.Wait();
            written.Add(line);
        });

        var said = Task.Run(() =>
        {
            foreach (var line in (string[])["held", "moved", "feed"]) queue.Enqueue(line);
        });
        await said.WaitAsync(TimeSpan.FromMinutes(1));
        Assert.Empty(written);
        taken.Set();
        await queue.DisposeAsync();

        Assert.Equal(["held", "moved", "feed"], written);
    }
}
