using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Jobs;
using Engraver.Galil.Tests.Links;
using Engraver.Links;

namespace Engraver.Galil.Tests.Sessions;

/// <summary>The conversation over a serial line with an echo (galil-dmc.md A.2, F.2, F.4).</summary>
public class SerialSessionTests
{
    [Fact]
    public async Task The_echo_is_switched_off_first_and_on_again_to_compare_it()
    {
        await using var bench = new SimulatedBench();
        var sent = new List<string>();
        await using (var session = await bench.OpenSerialAsync(19200, sent.Add))
        {
            Assert.Equal(("RS232", 1.0, 0), (session.Identity.Handle, session.Found.Wire.Echo, bench.Controller.Status.OpenHandles));
            Assert.Same(session.Commands, session.StopHandle);
        }

        Assert.StartsWith("\\\rEO 0\r", sent[0], StringComparison.Ordinal);
        Assert.Contains("EO 1\r", sent);
        await using var port = bench.Controller.OpenSerialConnection(19200);
        Assert.Equal("TP\r 0, 0, 0, 0\r\n:", Exchange(port, "TP\r"));
    }

    [Fact]
    public async Task An_echo_that_was_off_stays_off()
    {
        await using var bench = new SimulatedBench();
        await using (var port = bench.Controller.OpenSerialConnection(19200)) Exchange(port, "EO 0\r");

        await using (var session = await bench.OpenSerialAsync(19200)) Assert.Equal(0.0, session.Found.Wire.Echo);

        await using var after = bench.Controller.OpenSerialConnection(19200);
        Assert.Equal(" 0, 0, 0, 0\r\n:", Exchange(after, "TP\r"));
    }

    [Fact]
    public async Task A_byte_harmed_on_the_line_is_seen_in_the_echo_and_the_stop_still_goes_out()
    {
        await using var bench = new SimulatedBench();
        await using var session = await ControllerSession.OpenAsync(
            _ => Task.FromResult<IControllerLink>(new WithheldLink(bench.OpenSerialLink(19200)) { Corrupt = line => line.Replace("PRA=5000\r", "PRA=50000\r", StringComparison.Ordinal) }),
            new SessionOptions(), TimeProvider.System, CancellationToken.None);
        await session.Commands.SendAsync("SHA", CancellationToken.None);

        var harmed = await Assert.ThrowsAsync<EchoException>(async () => await session.Commands.SendAsync("PRA=5000", CancellationToken.None));

        Assert.Equal("serial memory received 'PRA=50000' instead of 'PRA=5000': the line corrupts data. Check the cable, the flow control and nearby sources of interference.", harmed.Message);
        Assert.Equal(Accepted.Silent, await session.StopHandle.SendAsync("ST AB", CancellationToken.None));
        Assert.Equal(new Accepted("1"), await session.Commands.SendAsync("MG 1{F1.0}", CancellationToken.None));
    }

    [Fact]
    public async Task Several_commands_of_one_line_are_answered_and_compared_one_by_one()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenSerialAsync(19200);

        Assert.Equal(new Accepted("1\n2"), await session.Commands.SendAsync("MG 1{F1.0};CAS;MG 2{F1.0}", CancellationToken.None));
        Assert.Equal("XX", Assert.IsType<Rejected>(await session.Commands.SendAsync("CAS;XX;a=5", CancellationToken.None)).Command);
        Assert.Equal(new Accepted("5"), await session.Commands.SendAsync("MG a{F1.0}", CancellationToken.None));
    }

    [Theory]
    [InlineData("DL\r#A\rEN\r")]
    [InlineData("DL\r#A\rWT 1")]
    [InlineData("MG \"half a message: ")]
    public async Task What_a_dead_host_left_half_said_is_ended(string left)
    {
        await using var bench = new SimulatedBench();
        await using var session = await OpenAfterAsync(bench, left);

        Assert.Equal("DMC2143 Rev 1.0o", session.Identity.Model);
    }

    [Fact]
    public async Task A_motion_that_a_dead_host_left_half_said_is_not_begun()
    {
        await using var bench = new SimulatedBench();
        await using var session = await OpenAfterAsync(bench, "SHA;PRA=5000\rBGA");

        Assert.False(bench.Controller.Status.IsMoving);
    }

    [Fact]
    public async Task A_stop_ends_a_long_download_behind_a_whole_line()
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var sent = new List<string>();
        var link = new WithheldLink(bench.OpenSerialLink(19200)) { Sending = text => { sent.Add(text); if (sent.Count == 4) stop.Cancel(); } };
        await using var channel = new CommandChannel(link, "A", TimeSpan.FromSeconds(60), TimeProvider.System, null);
        await channel.GreetAsync(CancellationToken.None);

        await Assert.ThrowsAnyAsync<OperationCanceledException>(
            async () => await channel.DownloadAsync(string.Join('\n', Enumerable.Repeat("VP 12345,-12345;VP 23456,-23456", 300)), stop.Token));
        var upload = Assert.IsType<Accepted>(await channel.UploadAsync(CancellationToken.None));

        Assert.Equal("\\", sent[^2]);
        Assert.InRange(upload.Data.Split('\n').Length, 4, 20);
        Assert.All(upload.Data.Split('\n'), line => Assert.Equal("VP 12345,-12345;VP 23456,-23456", line));
    }

    [Fact]
    public async Task A_whole_program_memory_goes_both_ways_at_1200_baud()
    {
        await using var bench = new SimulatedBench();
        await using var channel = new CommandChannel(bench.OpenSerialLink(1200), "A", TimeSpan.FromSeconds(60), TimeProvider.System, null);
        await channel.GreetAsync(CancellationToken.None);
        var program = string.Join('\n', Enumerable.Repeat("VP 12345,-12345;VP 23456,-23456", 1000));

        Assert.IsType<Accepted>(await channel.DownloadAsync(program, CancellationToken.None));

        Assert.Equal(new Accepted(program), await channel.UploadAsync(CancellationToken.None));
    }

    [Fact]
    public async Task A_line_where_nobody_answers_names_what_to_look_at()
    {
        var time = new TestKit.ManualTimeProvider();
        await using var channel = new CommandChannel(new ScriptedLink(_ => null), "A", TimeSpan.FromSeconds(2), time, null);
        var greeting = channel.GreetAsync(CancellationToken.None).AsTask();
        while (!greeting.IsCompleted)
        {
            time.Advance(TimeSpan.FromSeconds(1));
            await Task.Yield();
        }

        var failure = await Assert.ThrowsAsync<ControllerTimeoutException>(() => greeting);
        Assert.Contains("baud rate", failure.Message, StringComparison.Ordinal);
        Assert.Contains("flow=none", failure.Message, StringComparison.Ordinal);
    }

    /// <summary>A new host on the cable of one that sent something and ended.</summary>
    private static Task<ControllerSession> OpenAfterAsync(SimulatedBench bench, string left)
    {
        var port = bench.Controller.OpenSerialConnection(19200);
        Exchange(port, left);
        return ControllerSession.OpenAsync(
            _ => Task.FromResult<IControllerLink>(new StreamLink(port, "serial memory") { Line = new SerialLine(19200) }),
            new SessionOptions { ReplyTimeout = TimeSpan.FromSeconds(60) }, TimeProvider.System, CancellationToken.None);
    }

    private static string Exchange(Stream port, string text)
    {
        port.Write(Encoding.Latin1.GetBytes(text));
        var buffer = new byte[4096];
        return Encoding.Latin1.GetString(buffer, 0, port.Read(buffer, 0, buffer.Length));
    }
}
