using Engraver.Galil.Terminals;

namespace Engraver.Galil.Tests.Terminals;

public class TerminalLineTests
{
    [Theory]
    [InlineData("ST")]
    [InlineData(" ST ")]
    [InlineData("MG 1;ST")]
    [InlineData("RS")]
    [InlineData("BN")]
    [InlineData("BP")]
    [InlineData("BV")]
    public void What_stops_or_overwrites_everything_needs_the_word_of_confirmation(string line)
    {
        Assert.IsType<TerminalLine.Withheld>(TerminalLine.Read(line));
        Assert.Equal(new TerminalLine.ToSend(line.Trim()), TerminalLine.Read("confirm " + line.Trim()));
    }

    [Theory]
    [InlineData("ST AB")]
    [InlineData("STS")]
    [InlineData("AB")]
    [InlineData("MG \"RS;ST\"")]
    [InlineData("RSx=1")]
    [InlineData("quit=1")]
    [InlineData("")]
    public void Everything_else_goes_as_it_is(string line) => Assert.Equal(new TerminalLine.ToSend(line), TerminalLine.Read(line));

    [Theory]
    [InlineData("DL")]
    [InlineData("QD a[]")]
    [InlineData("QU a[]")]
    [InlineData("QR")]
    [InlineData("ED")]
    [InlineData("confirm DL")]
    [InlineData("MG \"\\\"")]
    [InlineData("MG 1\u0012")]
    public void What_would_hang_the_conversation_is_never_sent(string line) => Assert.IsType<TerminalLine.Withheld>(TerminalLine.Read(line));

    [Fact]
    public void A_line_longer_than_the_controller_takes_is_not_sent()
    {
        Assert.IsType<TerminalLine.ToSend>(TerminalLine.Read("MG " + new string('1', 77)));
        Assert.IsType<TerminalLine.Withheld>(TerminalLine.Read("MG " + new string('1', 78)));
    }

    [Fact]
    public void The_terminals_own_words_are_not_sent()
    {
        Assert.Equal(new TerminalLine.Help(""), TerminalLine.Read("help"));
        Assert.Equal(new TerminalLine.Help("VP"), TerminalLine.Read("help VP"));
        Assert.IsType<TerminalLine.History>(TerminalLine.Read("history"));
        Assert.IsType<TerminalLine.Quit>(TerminalLine.Read("quit"));
        Assert.IsType<TerminalLine.Quit>(TerminalLine.Read(" exit "));
    }
}
