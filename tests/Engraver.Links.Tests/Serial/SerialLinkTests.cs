using System.Text;
using Engraver.Core.Machines;
using Engraver.Links.Serial;
using Engraver.TestKit;

namespace Engraver.Links.Tests.Serial;

/// <summary>The link on a pseudo-terminal without a controller, with the kernel's interface.</summary>
public sealed class TermiosLinkTests() : SerialLinkTests(SerialDriver.Own);

/// <summary>What both drivers of serial devices do.</summary>
public abstract class SerialLinkTests(SerialDriver driver)
{
    protected static TimeSpan Patience { get; } = TimeSpan.FromSeconds(60);

    [Fact]
    public async Task Every_byte_arrives_as_it_is_both_ways()
    {
        using var cable = new PseudoTerminalPair();
        await using var link = Open(cable);
        var every = Encoding.Latin1.GetString([.. Enumerable.Range(0, 256).Select(value => (byte)value)]);

        await link.WriteAsync(Encoding.Latin1.GetBytes(every), CancellationToken.None);
        var heard = cable.Read(256);
        cable.Write(every);

        Assert.Equal(every, heard);
        Assert.Equal(every, await ReadAsync(link, 256));
        Assert.Equal(19200, link.Line?.Baud);
    }

    [Fact]
    public async Task Closing_ends_a_read_that_waits()
    {
        using var cable = new PseudoTerminalPair();
        var link = Open(cable);
        var reading = link.ReadAsync(new byte[16], CancellationToken.None).AsTask();

        await link.DisposeAsync().AsTask().WaitAsync(Patience);

        await Assert.ThrowsAsync<IOException>(() => reading.WaitAsync(Patience));
        await Assert.ThrowsAsync<IOException>(() => link.WriteAsync("TP\r"u8.ToArray(), CancellationToken.None).AsTask());
        await link.DisposeAsync();
    }

    [Fact]
    public async Task Closing_ends_a_write_that_waits()
    {
        using var cable = new PseudoTerminalPair();
        var link = Open(cable, new ManualTimeProvider());
        var writing = link.WriteAsync(new byte[1 << 20], CancellationToken.None).AsTask();

        await link.DisposeAsync().AsTask().WaitAsync(Patience);

        await Assert.ThrowsAsync<IOException>(() => writing.WaitAsync(Patience));
    }

    [Fact]
    public async Task A_pulled_adapter_fails_what_waits_and_what_comes_after()
    {
        var cable = new PseudoTerminalPair();
        await using var link = Open(cable);
        cable.Write("LAST:");
        var last = await ReadAsync(link, 5);
        var reading = link.ReadAsync(new byte[16], CancellationToken.None).AsTask();

        cable.Dispose();

        Assert.Equal("LAST:", last);
        var failure = await Assert.ThrowsAsync<IOException>(() => reading.WaitAsync(Patience));
        Assert.Contains("was disconnected", failure.Message, StringComparison.Ordinal);
        await Assert.ThrowsAsync<IOException>(() => link.WriteAsync("TP\r"u8.ToArray(), CancellationToken.None).AsTask());
    }

    [Fact]
    public async Task A_line_that_takes_no_byte_is_given_up_after_the_time_out()
    {
        using var cable = new PseudoTerminalPair();
        var time = new ManualTimeProvider();
        await using var link = Open(cable, time);
        var writing = link.WriteAsync(new byte[1 << 20], CancellationToken.None).AsTask();

        while (!writing.IsCompleted)
        {
            time.Advance(TimeSpan.FromSeconds(1));
            await Task.Yield();
        }

        var failure = await Assert.ThrowsAsync<IOException>(() => writing);
        Assert.Contains("accepted no data for 2 s", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task More_than_the_line_holds_gets_through_when_somebody_reads()
    {
        using var cable = new PseudoTerminalPair();
        await using var link = Open(cable);
        var writing = link.WriteAsync(Encoding.ASCII.GetBytes(new string('A', 100_000)), CancellationToken.None).AsTask();

        Assert.Equal(new string('A', 100_000), await Task.Run(() => cable.Read(100_000)).WaitAsync(Patience));
        await writing.WaitAsync(Patience);
    }

    [Fact]
    public async Task A_read_that_is_cancelled_loses_no_byte()
    {
        using var cable = new PseudoTerminalPair();
        await using var link = Open(cable);
        using var cancel = new CancellationTokenSource();
        var reading = link.ReadAsync(new byte[16], cancel.Token).AsTask();

        await cancel.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => reading);
        cable.Write("TP:");

        Assert.Equal("TP:", await ReadAsync(link, 3));
    }

    [Fact]
    public async Task What_an_earlier_host_left_unread_is_dropped()
    {
        using var cable = new PseudoTerminalPair();
        cable.Write("STALE\r");
        await using var link = Open(cable);
        cable.Write("NEW");

        Assert.Equal("NEW", await ReadAsync(link, 3));
    }

    [Fact]
    public async Task Two_programs_do_not_share_a_device()
    {
        using var cable = new PseudoTerminalPair();
        await using var first = Open(cable);

        var failure = Assert.Throws<ControllerLinkException>(() => Open(cable));

        Assert.Contains("in use", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_two_drivers_do_not_share_a_device()
    {
        using var cable = new PseudoTerminalPair();
        await using var first = Open(cable);

        var failure = Assert.Throws<ControllerLinkException>(() => Open(cable, other: driver == SerialDriver.Own ? SerialDriver.Ports : SerialDriver.Own));

        Assert.Contains("in use", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_closed_link_leaves_the_device_to_the_next_one()
    {
        using var cable = new PseudoTerminalPair();
        for (var times = 0; times < 3; times++)
        {
            await using var link = Open(cable, new ManualTimeProvider());
            await link.WriteAsync("TP\r"u8.ToArray(), CancellationToken.None);
            Assert.Equal("TP\r", cable.Read(3));
        }
    }

    [Fact]
    public async Task Closing_twice_at_once_is_closing()
    {
        using var cable = new PseudoTerminalPair();
        var link = Open(cable, new ManualTimeProvider());

        await Task.WhenAll(link.DisposeAsync().AsTask(), link.DisposeAsync().AsTask()).WaitAsync(Patience);

        await Assert.ThrowsAsync<IOException>(() => link.ReadAsync(new byte[1], CancellationToken.None).AsTask());
    }

    /// <summary>The device is free again, although the other side has not read what was written.</summary>
    [Fact]
    public async Task A_line_that_nobody_reads_is_closed_and_free_again()
    {
        using var cable = new PseudoTerminalPair();
        var time = new ManualTimeProvider();
        var link = Open(cable, time);
        var writing = link.WriteAsync(new byte[1 << 20], CancellationToken.None).AsTask();
        while (!writing.IsCompleted)
        {
            time.Advance(TimeSpan.FromSeconds(1));
            await Task.Yield();
        }

        await link.DisposeAsync().AsTask().WaitAsync(Patience);

        await Assert.ThrowsAsync<IOException>(() => writing);
        await using var again = Open(cable);
        cable.Write("NEW");
        Assert.Equal("NEW", await ReadAsync(again, 3));
    }

    [Fact]
    public async Task A_pulled_adapter_fails_a_write_that_waits()
    {
        var cable = new PseudoTerminalPair();
        await using var link = Open(cable, new ManualTimeProvider());
        var writing = link.WriteAsync(new byte[1 << 20], CancellationToken.None).AsTask();

        cable.Dispose();

        await Assert.ThrowsAsync<IOException>(() => writing.WaitAsync(Patience));
        await Assert.ThrowsAsync<IOException>(() => link.ReadAsync(new byte[1], CancellationToken.None).AsTask().WaitAsync(Patience));
    }

    [Fact]
    public async Task A_write_that_is_cancelled_ends_at_once()
    {
        using var cable = new PseudoTerminalPair();
        await using var link = Open(cable, new ManualTimeProvider());
        using var cancel = new CancellationTokenSource();
        var writing = link.WriteAsync(new byte[1 << 20], cancel.Token).AsTask();

        await cancel.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => writing.WaitAsync(Patience));
    }

    /// <summary>The link passes noise on; the protocol above judges it.</summary>
    [Fact]
    public async Task Noise_is_received_as_it_is_and_the_line_works_after_it()
    {
        using var cable = new PseudoTerminalPair();
        await using var link = Open(cable);
        var noise = Encoding.Latin1.GetString([.. Enumerable.Range(0, 2000).Select(i => (byte)((i * 167) ^ (i >> 3)))]);

        cable.Write(noise);
        Assert.Equal(noise, await ReadAsync(link, noise.Length));
        await link.WriteAsync("TP\r"u8.ToArray(), CancellationToken.None);

        Assert.Equal("TP\r", cable.Read(3));
    }

    [Fact]
    public async Task Waiting_for_sent_bytes_ends_when_the_device_has_sent_them()
    {
        using var cable = new PseudoTerminalPair();
        await using var link = Open(cable);
        await link.WriteAsync("END"u8.ToArray(), CancellationToken.None);

        await link.DrainAsync(CancellationToken.None).AsTask().WaitAsync(Patience);
        await link.DisposeAsync();

        Assert.Equal("END", cable.Read(3));
    }

    [Fact]
    public void A_device_that_is_not_there_is_told_by_the_systems_own_reason()
    {
        var refused = Assert.Throws<ControllerLinkException>(() => SerialLink.Open(new SerialAddress("/dev/engraver-nothing", 19200) { Driver = driver }, Patience, TimeProvider.System));

        Assert.Equal("No connection to /dev/engraver-nothing: the device cannot be opened (No such file or directory).", refused.Message);
    }

    [Theory]
    [InlineData("/dev/no-such-device")]
    [InlineData("/dev/null")]
    public void What_is_no_serial_line_is_a_link_that_never_came_up(string device)
    {
        var failure = Assert.Throws<ControllerLinkException>(() => SerialLink.Open(new SerialAddress(device, 19200) { Driver = driver }, TimeSpan.FromSeconds(2), TimeProvider.System));

        Assert.Contains(device, failure.Message, StringComparison.Ordinal);
    }

    protected static async Task<string> ReadAsync(ISerialLink link, int count)
    {
        using var patience = new CancellationTokenSource(Patience);
        var bytes = new byte[count];
        for (var read = 0; read < count;) read += await link.ReadAsync(bytes.AsMemory(read), patience.Token);
        return Encoding.Latin1.GetString(bytes);
    }

    /// <summary>The link at the other end of a cable without a controller.</summary>
    /// <param name="time">A clock of the test, on which a line that accepts no byte is given up after 2 s; null for the wall clock, whose time-out must not be
    /// reached on a busy computer.</param>
    private ISerialLink Open(PseudoTerminalPair cable, TimeProvider? time = null, SerialDriver? other = null) =>
        SerialLink.Open(new SerialAddress(cable.Device, 19200) { Driver = other ?? driver }, TimeSpan.FromSeconds(time is null ? 60 : 2), time ?? TimeProvider.System);
}
