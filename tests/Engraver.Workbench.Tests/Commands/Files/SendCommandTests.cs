using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Files;

public class SendCommandTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);

    [Fact]
    public async Task A_program_of_several_is_chosen_and_goes_over_the_line_with_the_bits_of_its_frame()
    {
        await using var talk = new CommandTestSession();
        using var cable = new PseudoTerminalPair();
        File.WriteAllText(talk.PathOf("two.agie"), "%\t001\n%\t777\n\t002\n");
        await talk.TypeAsync("SEND", "two.agie", "2");
        var sending = talk.TypeAsync($"serial://{cable.Device}?baud=115200&frame=7E1");
        var heard = await Task.Run(() => cable.Read(13)).WaitAsync(s_patience);

        Assert.IsType<InputResult.Done>(await sending.WaitAsync(s_patience));
        Assert.Equal("\u00A5\t\u00B7\u00B7\u00B7\u008D\n\t00\u00B2\u008D\n", heard);
        Assert.StartsWith("2 lines sent: 13 characters", talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.Progress.Fraction);
    }

    [Fact]
    public async Task What_cannot_be_sent_is_said_and_nothing_is_sent()
    {
        await using var talk = new CommandTestSession();
        File.WriteAllText(talk.PathOf("a.nc"), "G1 \u00FC\n");

        Assert.Contains("is not a serial line", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SEND", "a.nc", "tcp://localhost")).Message, StringComparison.Ordinal);
        Assert.Contains("cannot be read", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SEND", "none.nc")).Message, StringComparison.Ordinal);
        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SEND", "a.nc", "serial:///dev/engraver-nothing?frame=7E1")).Reason);
        Assert.Contains("SND0002", talk.Said, StringComparison.Ordinal);
        Assert.Equal(CommandFailure.LinkLost, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SEND", "a.nc", "serial:///dev/engraver-nothing")).Reason);
    }
}
