using System.Net;
using System.Net.Sockets;
using Engraver.Core.Machines;

namespace Engraver.Links.Tests;

/// <summary>The port of <c>clock=</c> may have no listener, another service, or one that ends in the middle.</summary>
public sealed class SharedClockTests : IDisposable
{
    private readonly TcpListener _other = new(IPAddress.Loopback, 0);

    public SharedClockTests() => _other.Start();

    public void Dispose() => _other.Dispose();

    private int Port => ((IPEndPoint)_other.LocalEndpoint).Port;

    [Fact]
    public void A_port_at_which_nobody_listens_is_refused_by_its_number_with_what_to_do()
    {
        var port = Port;
        _other.Stop();

        var refused = Assert.Throws<ControllerLinkException>(() => SharedClock.Acquire(port));
        Assert.StartsWith($"No clock at port {port} of this computer: ", refused.Message, StringComparison.Ordinal);
        Assert.EndsWith("or omit clock=.", refused.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("220 mail.example ready\n", "the service at this port is not a clock")]
    [InlineData("-5\n", "the service at this port is not a clock")]
    [InlineData("\n", "the service at this port is not a clock")]
    [InlineData("", "the other end closed the connection")]
    [InlineData("17", "the other end closed the connection")]
    [InlineData("0000000000000000000000000000000000000000000000000000000000000000000000", "the other end closed the connection")]
    public async Task Somebody_who_is_no_clock_is_refused_and_the_reason_is_told(string answer, string reason)
    {
        var taking = Task.Run(() => SharedClock.Acquire(Port));
        using (var other = await _other.AcceptSocketAsync())
        {
            await AnswerAsync(other, answer);
            other.Shutdown(SocketShutdown.Send);
            var refused = await Assert.ThrowsAsync<ControllerLinkException>(() => taking);
            Assert.Contains(reason, refused.Message, StringComparison.Ordinal);
        }
    }

    /// <summary>The times in the protocol: whole microseconds since the controller was switched on.</summary>
    [Fact]
    public async Task The_time_is_what_the_other_end_says()
    {
        var taking = Task.Run(() => SharedClock.Acquire(Port));
        using var other = await _other.AcceptSocketAsync();
        await AnswerAsync(other, "2500000\n");
        using var clock = await taking;
        var asking = Task.Run(clock.GetTimestamp);
        await AnswerAsync(other, "4000000\n");

        Assert.Equal(TimeSpan.FromSeconds(4), clock.GetElapsedTime(0, await asking));
    }

    /// <summary>Otherwise the wait would never end, and the host would hang with its machine.</summary>
    [Fact]
    public async Task A_wait_ends_by_the_wall_when_the_other_end_is_gone()
    {
        var taking = Task.Run(() => SharedClock.Acquire(Port));
        using var other = await _other.AcceptSocketAsync();
        await AnswerAsync(other, "1000000\n");
        using var clock = await taking;
        var waited = new TaskCompletionSource();
        clock.Invalidate();
        var starting = Task.Run(() => clock.CreateTimer(_ => waited.SetResult(), null, TimeSpan.FromMilliseconds(20), Timeout.InfiniteTimeSpan));
        await AnswerAsync(other, "1000000\n");
        await using var timer = await starting;
        Assert.Equal("wait 20000\n", await HeardAsync(other));
        other.Dispose();

        await waited.Task;
        Assert.True(clock.GetElapsedTime(0, clock.GetTimestamp()) >= TimeSpan.FromMilliseconds(1020));
    }

    /// <summary>A controller with a host that no longer waits would let no time pass: its machine would never come to rest.</summary>
    [Fact]
    public async Task A_clock_that_does_not_answer_as_one_is_given_back()
    {
        var taking = Task.Run(() => SharedClock.Acquire(Port));
        using var other = await _other.AcceptSocketAsync();
        await AnswerAsync(other, "1000000\n");
        using var clock = await taking;
        clock.Invalidate();
        var asking = Task.Run(clock.GetTimestamp);
        await AnswerAsync(other, "what?\n");
        await asking;

        Assert.Equal("", await HeardAsync(other).WaitAsync(TimeSpan.FromMinutes(1)));
    }

    /// <summary>The case of a host that continues before its cancelled wait is disposed.</summary>
    [Fact]
    public async Task A_wait_that_is_given_up_leaves_one_that_began_behind_it()
    {
        var taking = Task.Run(() => SharedClock.Acquire(Port));
        using var other = await _other.AcceptSocketAsync();
        await AnswerAsync(other, "1000000\n");
        using var clock = await taking;
        clock.Invalidate();
        var starting = Task.Run(() => clock.CreateTimer(_ => { }, null, TimeSpan.FromSeconds(10), Timeout.InfiniteTimeSpan));
        await AnswerAsync(other, "1000000\n");
        var given = await starting;
        Assert.Equal("wait 10000000\n", await HeardAsync(other));
        var passed = new TaskCompletionSource();
        await using var second = clock.CreateTimer(_ => passed.SetResult(), null, TimeSpan.FromMilliseconds(5), Timeout.InfiniteTimeSpan);
        await given.DisposeAsync();
        Assert.StartsWith("stop\n", await HeardAsync(other), StringComparison.Ordinal);
        await other.SendAsync("1000000\n"u8.ToArray());

        var heard = await HeardAsync(other).WaitAsync(TimeSpan.FromMinutes(1));
        if (heard == "stop\n") heard = await HeardAsync(other); // two of them may arrive separately
        Assert.EndsWith("wait 5000\n", heard, StringComparison.Ordinal);
        await other.SendAsync("1005000\n"u8.ToArray());
        await passed.Task;
    }

    private static async Task AnswerAsync(Socket other, string answer)
    {
        Assert.Equal("now\n", await HeardAsync(other));
        if (answer.Length > 0) await other.SendAsync(System.Text.Encoding.ASCII.GetBytes(answer));
    }

    private static async Task<string> HeardAsync(Socket other)
    {
        var line = new byte[64];
        var count = await other.ReceiveAsync(line);
        return System.Text.Encoding.ASCII.GetString(line, 0, count);
    }
}
