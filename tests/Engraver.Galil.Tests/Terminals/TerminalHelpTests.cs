using Engraver.Galil.Protocol;
using Engraver.Galil.Terminals;

namespace Engraver.Galil.Tests.Terminals;

public class TerminalHelpTests
{
    [Fact]
    public void Every_code_of_TC_is_explained()
    {
        foreach (var code in Enum.GetValues<TcCode>().Where(code => code != TcCode.None)) Assert.Contains(TcCodes.Text(code), TerminalHelp.About($"{(int)code}"), StringComparison.Ordinal);
        Assert.Equal("TC 22  Begin not possible due to limit switch: the move goes towards an active limit switch or beyond a soft limit", TerminalHelp.About("22"));
    }

    [Theory]
    [InlineData("23", "TC 23 is not defined.")]
    [InlineData("0", "TC 0 is not defined.")]
    [InlineData("LD", "'LD' is not a command of the DMC-21x3; help lists all commands.")]
    public void What_is_not_there_is_said(string subject, string answer) => Assert.Equal(answer, TerminalHelp.About(subject));

    [Fact]
    public void Help_alone_lists_every_command()
    {
        var words = TerminalHelp.About("").Split([' ', '\n']);

        Assert.All(CommandHelpTable.All, help => Assert.Contains(help.Command, words));
    }
}
