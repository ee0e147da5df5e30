using System.Text.RegularExpressions;
using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.Galil.Tests.Links;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Protocol;

/// <summary>Lines of several segments on a serial line with an echo: where the controller sends its prompts is not known (galil-dmc.md A.2, A.3).</summary>
public partial class WholeLineTests
{
    private const string Segments = "VP 11,-2;CR 500,90,-180.25;LI 3,4,5<2000;VP 0,0";

    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(30);

    public enum PromptTime
    {
        BehindTheSeparator,
        Later,
        AtTheEnd,
    }

    public static TheoryData<PromptTime> Times => new(Enum.GetValues<PromptTime>());

    [Theory]
    [MemberData(nameof(Times))]
    public async Task A_line_goes_out_whole_and_its_prompts_may_come_anywhere_within_the_echo(PromptTime when)
    {
        var (link, _) = Controller(when);
        await using var channel = await OpenAsync(link);

        Assert.Equal(Accepted.Silent, await channel.SendWholeAsync(Segments, CancellationToken.None));
        Assert.Equal(Accepted.Silent, await channel.SendWholeAsync("VP 1,2;VP 3,4", CancellationToken.None));
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
        Assert.Equal([Segments + "\r", "VP 1,2;VP 3,4\r", "MG x\r"], link.Written);
    }

    /// <summary>The damaged bytes reach the controller, which echoes and executes what it received.</summary>
    [Theory]
    [MemberData(nameof(Times))]
    public async Task No_damaged_missing_or_additional_byte_is_accepted_and_none_waits_for_the_time_out(PromptTime when)
    {
        for (var at = 0; at <= Segments.Length; at++)
        {
            string[] harmed =
            [
                .. at < Segments.Length ? (string[])[Segments.Remove(at, 1) + "\r"] : [],
                .. "1;:?X-\n\0".SelectMany(value => new[] { (Segments + "\r").Insert(at, value.ToString()), (Segments + "\r").Remove(at, 1).Insert(at, value.ToString()) }),
            ];
            foreach (var received in harmed.Where(text => text != Segments + "\r" && text != Segments + "\n")) await AssertNotAcceptedAsync(when, received, received);
        }
    }

    /// <summary>The controller received the line; the bytes are damaged on their way back.</summary>
    [Theory]
    [MemberData(nameof(Times))]
    public async Task A_damaged_echo_is_reported_and_so_is_a_prompt_that_became_another_byte(PromptTime when)
    {
        var whole = Heard(Segments + "\r", when);
        for (var at = 0; at < whole.Length; at++)
        {
            foreach (var value in "1X;") if (value != whole[at]) await AssertNotAcceptedAsync(when, Segments + "\r", whole.Remove(at, 1).Insert(at, value.ToString()));
            if (whole[at] is not (':' or '?' or '\r')) await AssertNotAcceptedAsync(when, Segments + "\r", whole.Remove(at, 1));
        }
    }

    [Fact]
    public async Task A_lost_line_end_ends_in_a_time_out_that_names_the_line()
    {
        var time = new ManualTimeProvider();
        var (link, _) = Controller(PromptTime.BehindTheSeparator);
        await using var channel = await OpenAsync(link, time);
        link.Heard = _ => Heard(Segments, PromptTime.BehindTheSeparator);

        var sent = channel.SendWholeAsync(Segments, CancellationToken.None).AsTask();
        time.Advance(TimeSpan.FromSeconds(3));

        Assert.Contains(Segments, (await Assert.ThrowsAsync<ControllerTimeoutException>(() => sent)).Message, StringComparison.Ordinal);
    }

    /// <summary>A controller that does not echo line ends.</summary>
    [Theory]
    [MemberData(nameof(Times))]
    public async Task The_end_of_a_line_need_not_be_echoed(PromptTime when)
    {
        var (link, heard) = Controller(when);
        link.Heard = text => text == "MG \"ECHO\"\r" ? "MG \"ECHO\"ECHO\r\n:" : text == "MG x\r" ? "MG x 5.0000\r\n:" : heard(text)?.Replace("\r", "", StringComparison.Ordinal);
        await using var channel = await OpenAsync(link);

        Assert.Equal(Accepted.Silent, await channel.SendWholeAsync(Segments, CancellationToken.None));
        Assert.Equal(Accepted.Silent, await channel.SendWholeAsync("VP 1,2;VP 3,4", CancellationToken.None));
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
    }

    [Theory]
    [InlineData(PromptTime.BehindTheSeparator, true)]
    [InlineData(PromptTime.BehindTheSeparator, false)]
    [InlineData(PromptTime.Later, true)]
    [InlineData(PromptTime.Later, false)]
    [InlineData(PromptTime.AtTheEnd, true)]
    [InlineData(PromptTime.AtTheEnd, false)]
    public async Task A_refused_statement_is_named_whether_or_not_those_after_it_are_answered(PromptTime when, bool continues)
    {
        var (link, _) = Controller(when, continues);
        await using var channel = await OpenAsync(link);

        var refused = Assert.IsType<Rejected>(await channel.SendWholeAsync("VP 1,2;VX 3,4;VP 5,6;VP 7,8", CancellationToken.None).AsTask().WaitAsync(s_patience));

        Assert.Equal(("VX 3,4", 1, TcCode.UnrecognizedCommand), (refused.Command, refused.Part, refused.Code));
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
        Assert.Equal(Accepted.Silent, await channel.SendWholeAsync("VP 1,2;VP 3,4", CancellationToken.None));
    }

    /// <summary>The prompts of the statements after the refused one are late: they come after TC1 was sent, before its reply.</summary>
    [Fact]
    public async Task Late_prompts_after_a_refused_statement_are_not_those_of_the_next_line()
    {
        var (link, heard) = Controller(PromptTime.AtTheEnd);
        await using var channel = await OpenAsync(link);
        link.Heard = text => text.StartsWith("VP 1,2;", StringComparison.Ordinal) ? text + ":?" : text == "TC1\r" ? ":TC:1\r1 Unrecognized command\r\n:" : heard(text);

        var refused = Assert.IsType<Rejected>(await channel.SendWholeAsync("VP 1,2;VX 3,4;VP 5,6;VP 7,8", CancellationToken.None).AsTask().WaitAsync(s_patience));

        Assert.Equal(1, refused.Part);
        Assert.Equal(Accepted.Silent, await channel.SendWholeAsync("VP 1,2", CancellationToken.None));
    }

    [Theory]
    [InlineData(EchoTime.BehindTheAnswer)]
    [InlineData(EchoTime.BeforeTheAnswer)]
    [InlineData(EchoTime.AmidTheAnswer)]
    public async Task A_stop_overtakes_the_prompts_of_the_line_under_way(EchoTime echo)
    {
        const string Stop = "CB 1;STS;ST AB;HX0";
        var link = new EchoingLink(Answer, echo);
        await using var channel = await OpenAsync(link);
        link.Kept = Segments;
        var late = channel.SendWholeAsync(Segments, CancellationToken.None).AsTask();

        await channel.SendUrgentAsync(Stop);
        Assert.Equal([Segments + "\r", Stop + "\r"], link.Written);
        link.Release();

        Assert.Equal(Accepted.Silent, await late.WaitAsync(s_patience));
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
    }

    [Fact]
    public async Task What_is_answered_by_more_than_prompts_does_not_go_out_whole()
    {
        var (link, _) = Controller(PromptTime.AtTheEnd);
        await using var channel = await OpenAsync(link);

        foreach (var line in (string[])["VP 1,2;MG \"a\"", "SP ?;VP 1,2", "VP 1,2;x=:"]) await Assert.ThrowsAsync<ArgumentException>(async () => await channel.SendWholeAsync(line, CancellationToken.None));
        Assert.Empty(link.Written);
    }

    private static async Task AssertNotAcceptedAsync(PromptTime when, string received, string back)
    {
        var (link, heard) = Controller(when);
        await using var channel = await OpenAsync(link);
        var answer = back == received ? Heard(received, when) : back;
        link.Heard = text => text == Segments + "\r" ? answer : heard(text);
        try
        {
            var reply = await channel.SendWholeAsync(Segments, CancellationToken.None).AsTask().WaitAsync(s_patience);
            Assert.True(reply is Rejected, $"{received.Replace('\r', '|')} was accepted; heard {answer.Replace('\r', '|')}");
        }
        catch (EchoException)
        {
            Assert.Equal(Accepted.Silent, await channel.SendAsync("ST AB", CancellationToken.None));
        }
        catch (TimeoutException)
        {
            Assert.Fail($"No end after {answer.Replace('\r', '|')}");
        }
    }

    /// <summary>A controller that answers lines of segments with its prompts at this time, and other lines as <see cref="EchoingLink"/> does.</summary>
    private static (EchoingLink Link, Func<string, string?> Heard) Controller(PromptTime when, bool continues = true)
    {
        string? HeardOf(string text) => text.Contains(';', StringComparison.Ordinal) ? Heard(text, when, continues) : null;
        return (new EchoingLink(Answer, EchoTime.BehindTheAnswer) { Heard = HeardOf }, HeardOf);
    }

    /// <summary>The echo of what was received, and a prompt for each statement.</summary>
    private static string Heard(string received, PromptTime when, bool continues = true)
    {
        var (heard, prompts, since, start, isRefused) = ("", "", 0, 0, false);
        for (var i = 0; i < received.Length; i++)
        {
            heard += received[i];
            if (prompts.Length > 0 && when == PromptTime.Later && ++since == 3) (heard, prompts, since) = (heard + prompts, "", 0);
            if (received[i] is not (';' or '\r')) continue;
            var isSegment = Segment().IsMatch(received[start..i]);
            if (continues || !isRefused) prompts += isSegment ? ":" : "?";
            (start, isRefused) = (i + 1, isRefused || !isSegment);
            if (when == PromptTime.BehindTheSeparator) (heard, prompts) = (heard + prompts, "");
        }

        return heard + prompts;
    }

    private static string Answer(string command) => command switch { "MG x" => " 5.0000\r\n", "MG \"ECHO\"" => "ECHO\r\n", "TC1" => "1 Unrecognized command\r\n", _ => "" };

    private static async Task<CommandChannel> OpenAsync(EchoingLink link, ManualTimeProvider? time = null)
    {
        var channel = new CommandChannel(link, "A", TimeSpan.FromSeconds(2), time ?? new ManualTimeProvider(), null);
        await channel.GreetAsync(CancellationToken.None);
        await channel.CompareEchoAsync(CancellationToken.None);
        link.Written.Clear();
        return channel;
    }

    [GeneratedRegex("^(VP|CR|LI) -?[0-9.]+(,-?[0-9.]+)+(<[0-9]+)?$")]
    private static partial Regex Segment();
}
