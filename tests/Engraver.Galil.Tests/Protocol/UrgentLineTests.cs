using Engraver.Galil.Protocol;
using Engraver.Galil.Tests.Links;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Protocol;

/// <summary>The stop on a serial line: sent before a late reply arrives, with the echo compared (galil-dmc.md A.2).</summary>
public class UrgentLineTests
{
    private const string Stop = "CB 1;STS;ST AB;HX0";

    [Theory]
    [InlineData(EchoTime.BehindTheAnswer)]
    [InlineData(EchoTime.BeforeTheAnswer)]
    [InlineData(EchoTime.AmidTheAnswer)]
    public async Task A_question_that_is_overtaken_has_its_own_answer_wherever_the_echo_comes(EchoTime echo)
    {
        var link = new EchoingLink(Answer, echo);
        await using var channel = await OpenAsync(link);
        link.Kept = "MG _RPA";
        var late = channel.SendAsync("MG _RPA", CancellationToken.None).AsTask();

        await channel.SendUrgentAsync(Stop);
        Assert.Equal(["MG _RPA\r", Stop + "\r"], link.Written);
        link.Release();

        Assert.Equal(new Accepted("1111.0000"), await late);
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
        await AssertComparesAsync(channel, link);
    }

    [Theory]
    [InlineData(EchoTime.BehindTheAnswer)]
    [InlineData(EchoTime.BeforeTheAnswer)]
    public async Task A_command_that_is_overtaken_has_its_own_answer(EchoTime echo)
    {
        var link = new EchoingLink(Answer, echo);
        await using var channel = await OpenAsync(link);
        link.Kept = "VP 1,2";
        var late = channel.SendAsync("VP 1,2", CancellationToken.None).AsTask();

        await channel.SendUrgentAsync(Stop);
        link.Release();

        Assert.Equal(Accepted.Silent, await late);
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
        Assert.DoesNotContain(link.Written, line => line.StartsWith('\\'));
    }

    [Fact]
    public async Task On_a_free_line_it_goes_out_whole_and_the_echo_of_the_next_command_is_compared()
    {
        var link = new EchoingLink(Answer, EchoTime.BehindTheAnswer);
        await using var channel = await OpenAsync(link);

        await channel.SendUrgentAsync(Stop);
        await channel.SendUrgentAsync(Stop);

        Assert.Equal([Stop + "\r", Stop + "\r"], link.Written);
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
        await AssertComparesAsync(channel, link);
    }

    [Fact]
    public async Task Where_the_echo_of_an_urgent_line_is_harmed_the_next_one_waits_for_its_turn()
    {
        var link = new EchoingLink(Answer, EchoTime.AmidTheAnswer);
        await using var channel = await OpenAsync(link);
        link.Kept = "MG _RPA";
        var late = channel.SendAsync("MG _RPA", CancellationToken.None).AsTask();
        await channel.SendUrgentAsync(Stop);
        link.Release();
        await late;
        link.Written.Clear();

        await channel.SendUrgentAsync(Stop);

        Assert.Empty(link.Written);
        Assert.Equal(Accepted.Silent, await channel.SendAsync(Stop, CancellationToken.None));
        Assert.Equal(["CB 1\r", "STS\r", "ST AB\r", "HX0\r"], link.Written);
    }

    /// <summary>After a damaged line the greeting is sent again; a stop meanwhile does not wait for that.</summary>
    [Fact]
    public async Task It_goes_out_while_a_harmed_line_is_greeted_again()
    {
        var link = new EchoingLink(Answer, EchoTime.BehindTheAnswer) { Corrupt = line => line == "VP 1,2" ? "VP 1,3" : line };
        await using var channel = await OpenAsync(link);
        link.Kept = "MG \"READY\"";
        var harmed = channel.SendAsync("VP 1,2", CancellationToken.None).AsTask();

        await channel.SendUrgentAsync(Stop);
        Assert.Equal(Stop + "\r", link.Written[^1]);
        link.Release();

        await Assert.ThrowsAsync<EchoException>(() => harmed);
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
    }

    /// <summary>Regression: after garbage, when echoes are no longer compared, a stop on a free line waited for its turn, and one in 70 came after the next
    /// query: 47 ms at 19,200 baud.</summary>
    [Fact]
    public async Task It_goes_out_at_once_on_a_line_without_echoes_whoever_takes_the_turn_next()
    {
        var link = new EchoingLink(Answer, EchoTime.BehindTheAnswer) { Corrupt = line => line == "VP 1,2" ? "VP 1,3" : line };
        await using var channel = await OpenAsync(link);
        await Assert.ThrowsAsync<EchoException>(async () => await channel.SendAsync("VP 1,2", CancellationToken.None));
        link.Written.Clear();

        await channel.SendUrgentAsync(Stop);

        Assert.Equal([Stop + "\r"], link.Written);
        Assert.Equal(new Accepted("5.0000"), await channel.SendAsync("MG x", CancellationToken.None));
        Assert.Equal(Accepted.Silent, await channel.SendAsync(Stop, CancellationToken.None));
    }

    private static string Answer(string command) => command switch { "MG _RPA" => " 1111.0000\r\n", "MG x" => " 5.0000\r\n", "MG \"ECHO\"" => "ECHO\r\n", _ => "" };

    private static async Task<CommandChannel> OpenAsync(EchoingLink link)
    {
        var channel = new CommandChannel(link, "A", TimeSpan.FromSeconds(2), new ManualTimeProvider(), null);
        await channel.GreetAsync(CancellationToken.None);
        await channel.CompareEchoAsync(CancellationToken.None);
        link.Written.Clear();
        return channel;
    }

    /// <summary>A command that the controller receives differently is detected.</summary>
    private static async Task AssertComparesAsync(CommandChannel channel, EchoingLink link)
    {
        link.Corrupt = line => line == "VP 1,2" ? "VP 1,3" : line;
        await Assert.ThrowsAsync<EchoException>(async () => await channel.SendAsync("VP 1,2", CancellationToken.None));
    }
}
