using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.Galil.Tests.Links;
using Engraver.Links.Recording;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Protocol;

public class CommandChannelTests
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(2);
    private readonly ManualTimeProvider _time = new();

    [Fact]
    public async Task A_question_mark_becomes_a_refusal_with_code_text_and_command()
    {
        var link = new ScriptedLink(line => line switch { "BGS" => "?", "TC1" => " 20  Begin not valid with motor off\r\n:", _ => ":" });
        await using var channel = Channel(link);

        var reply = await channel.SendAsync("BGS", CancellationToken.None);

        Assert.Equal(new Rejected(TcCode.BeginNotValidWithMotorOff, "Begin not valid with motor off", "BGS"), reply);
        Assert.Equal(["BGS", "TC1"], link.Received);
    }

    [Fact]
    public async Task A_line_of_three_parts_waits_for_three_prompts()
    {
        var link = new ScriptedLink(line => line == "x=1;MG \"a;b\";y=2" ? ":a;b\r\n::" : " 7.0000\r\n:");
        await using var channel = Channel(link);

        var three = await channel.SendAsync("x=1;MG \"a;b\";y=2", CancellationToken.None);
        var one = await channel.SendAsync("MG z", CancellationToken.None);

        Assert.Equal(new Accepted("a;b"), three);
        Assert.Equal(new Accepted("7.0000"), one);
    }

    [Fact]
    public async Task The_refused_part_of_a_line_is_named()
    {
        var link = new ScriptedLink(line => line == "TC1" ? "9 Variable error\r\n:" : ":?:");
        await using var channel = Channel(link);

        var reply = await channel.SendAsync("x=1;y=q;z=3;", CancellationToken.None);

        Assert.Equal("y=q", Assert.IsType<Rejected>(reply).Command);
        Assert.Equal("x=1;y=q;z=3", link.Received[0]);
    }

    [Fact]
    public async Task Silence_ends_in_a_time_out_and_the_channel_is_dead_from_then_on()
    {
        await using var channel = Channel(new ScriptedLink(_ => null));
        var waiting = channel.SendAsync("TP", CancellationToken.None).AsTask();

        _time.Advance(Limit - TimeSpan.FromTicks(1));
        Assert.False(waiting.IsCompleted);
        _time.Advance(TimeSpan.FromTicks(1));

        await Assert.ThrowsAsync<ControllerTimeoutException>(() => waiting);
        Assert.True(channel.IsBroken);
        await Assert.ThrowsAsync<ControllerLinkException>(() => channel.SendAsync("TP", CancellationToken.None).AsTask());
    }

    [Fact]
    public async Task The_time_of_an_answered_command_does_not_count_for_the_next()
    {
        var answers = true;
        await using var channel = Channel(new ScriptedLink(_ => answers ? ":" : null));
        await channel.SendAsync("TP", CancellationToken.None);
        _time.Advance(Limit / 2);
        answers = false;
        var waiting = channel.SendAsync("TP", CancellationToken.None).AsTask();

        _time.Advance(Limit - TimeSpan.FromTicks(1));
        Assert.False(waiting.IsCompleted);
        _time.Advance(TimeSpan.FromTicks(1));

        await Assert.ThrowsAsync<ControllerTimeoutException>(() => waiting);
    }

    [Fact]
    public async Task A_closed_connection_is_a_lost_link()
    {
        var link = new ScriptedLink(_ => null);
        await using var channel = Channel(link);
        var waiting = channel.SendAsync("TP", CancellationToken.None).AsTask();

        link.Close();

        await Assert.ThrowsAsync<ControllerLinkException>(() => waiting);
    }

    [Fact]
    public async Task A_cancelled_caller_sends_nothing_but_what_was_sent_is_waited_for()
    {
        using var cancelled = new CancellationTokenSource();
        var link = new ScriptedLink(line => line == "MG 1" ? null : " 2.0000\r\n:");
        await using var channel = Channel(link);
        var waiting = channel.SendAsync("MG 1", cancelled.Token).AsTask();

        await cancelled.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => channel.SendAsync("BGS", cancelled.Token).AsTask());
        link.Reply(" 1.0000\r\n:");

        Assert.Equal(new Accepted("1.0000"), await waiting);
        Assert.Equal(new Accepted("2.0000"), await channel.SendAsync("MG 2", CancellationToken.None));
        Assert.DoesNotContain("BGS", link.Received);
    }

    [Fact]
    public async Task A_reason_that_is_none_is_a_protocol_violation()
    {
        await using var channel = Channel(new ScriptedLink(line => line == "TC1" ? "HTTP/1.1 400\r\n:" : "?"));

        await Assert.ThrowsAsync<ProtocolViolationException>(() => channel.SendAsync("QZ", CancellationToken.None).AsTask());
    }

    [Fact]
    public async Task A_download_waits_for_two_prompts_and_replaces_empty_lines()
    {
        var link = new ScriptedLink(line => line switch { "" => "::", "MG 1" => " 1.0000\r\n:", _ => null });
        await using var channel = Channel(link);

        Assert.Equal(new Accepted(""), await channel.DownloadAsync("#A\n\nEN\n", CancellationToken.None));

        Assert.Equal(["DL", "#A", "'", "EN", ""], link.Received);
        Assert.Equal(new Accepted("1.0000"), await channel.SendAsync("MG 1", CancellationToken.None));
    }

    [Theory]
    [InlineData("#A\r\nEN\r\n\x1A:", "#A\nEN")]
    [InlineData("\r\n\x1A:", "")]
    [InlineData("\x1A:", "")]
    [InlineData(":", "")]
    public async Task An_upload_is_lines_without_the_end_mark_and_may_be_empty(string wire, string expected)
    {
        await using var channel = Channel(new ScriptedLink(_ => wire));

        Assert.Equal(new Accepted(expected), await channel.UploadAsync(CancellationToken.None));
    }

    [Fact]
    public async Task What_breaks_the_limits_of_a_line_never_reaches_the_wire()
    {
        var link = new ScriptedLink(_ => ":");
        await using var channel = Channel(link);

        await Assert.ThrowsAsync<ArgumentException>(async () => await channel.SendAsync(new string('A', 81), CancellationToken.None));
        await Assert.ThrowsAsync<ArgumentException>(async () => await channel.SendAsync("A\rB", CancellationToken.None));
        await Assert.ThrowsAsync<ArgumentException>(async () => await channel.DownloadAsync("#A\nMG \"\\\"", CancellationToken.None));
        await Assert.ThrowsAsync<ArgumentException>(async () => await channel.DownloadAsync(new string('A', 81), CancellationToken.None));

        Assert.Empty(link.Received);
    }

    [Fact]
    public async Task The_trace_holds_every_line_with_its_time_and_handle()
    {
        using var text = new StringWriter { NewLine = "\n" };
        var trace = new WireTrace(text, _time);
        await using var channel = new CommandChannel(new ScriptedLink(_ => " 1.0000\r\n:"), "A", Limit, _time, trace);

        _time.Advance(TimeSpan.FromMilliseconds(1.5));
        await channel.SendAsync("MG x", CancellationToken.None);
        await trace.CloseAsync(CancellationToken.None);

        Assert.Equal("0.001500 A > MG x\n0.001500 A <  1.0000 | :\n", text.ToString());
    }

    private CommandChannel Channel(ScriptedLink link) => new(link, "A", Limit, _time, null);
}
