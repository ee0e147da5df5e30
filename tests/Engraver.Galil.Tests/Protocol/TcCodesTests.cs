using Engraver.Galil.Protocol;

namespace Engraver.Galil.Tests.Protocol;

public class TcCodesTests
{
    [Theory]
    [InlineData("1 Unrecognized command", 1, "Unrecognized command")]
    [InlineData(" 17\tED, BN and DL not valid while program running", 17, "ED, BN and DL not valid while program running")]
    [InlineData("22   Begin not possible", 22, "Begin not possible")]
    [InlineData("250 Something of a newer firmware", 250, "Something of a newer firmware")]
    [InlineData("6", 6, "Number out of range")]
    public void The_answer_of_TC1_is_split_at_its_first_white_space(string answer, int code, string text)
    {
        Assert.True(TcCodes.TryParse(answer, out var read, out var words));
        Assert.Equal((code, text), ((int)read, words));
    }

    [Fact]
    public void Every_named_code_has_a_text()
    {
        foreach (var code in Enum.GetValues<TcCode>().Where(code => code != TcCode.None)) Assert.DoesNotContain("error " + (int)code, TcCodes.Text(code), StringComparison.Ordinal);
    }

    [Fact]
    public void A_refusal_explains_itself_in_one_sentence() => Assert.Equal(
        "The controller refused 'BGS' with TC 20 (Begin not valid with motor off): switch the motors on (SH) first.",
        new Rejected(TcCode.BeginNotValidWithMotorOff, "Begin not valid with motor off", "BGS").Explain());
}
