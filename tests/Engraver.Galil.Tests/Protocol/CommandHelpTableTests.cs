using Engraver.Galil.Protocol;

namespace Engraver.Galil.Tests.Protocol;

public class CommandHelpTableTests
{
    /// <summary>galil-dmc.md 0.4, commands listed for the DMC-21x3.</summary>
    private const string Listed =
        "AB AC AD AF AG AI AL AM AO AP AQ AR AS AT AU AV BA BC BD BG BI BK BL BM BN BP BR BV BZ CA CB CD CE CF CI CM CN CR CS CW DA DC DE DL DM DP DR DT DV "
        + "EA EB EC ED EG ELSE EM EN ENDIF EO EP EQ ER ES ET EW FA FE FI FL FV GA GD GM GR HM HS HX IA IF IH II IK IL IP IT JG JP JS KD KI KP KS LA LC LE LI LL "
        + "LM LS LV LZ MB MC MF MG MO MR MT MW NB NF NO NZ OB OC OE OF OP PA PF PL PT PR QD QH QR QS QU QZ RA RC RD RE RI RL RP RS SB SC SH SL SP ST TA TB TC TD "
        + "TE TH TI TIME TK TL TM TN TP TR TS TT TV TW TZ UL VA VD VE VF VM VP VR VS WH WT XQ YA YB YC YR YS ZS";

    [Fact]
    public void Every_command_of_the_controller_is_explained() => Assert.Equal(Listed.Split(' ').Order(StringComparer.Ordinal), CommandHelpTable.All.Select(help => help.Command));

    [Theory]
    [InlineData("VP", "VP")]
    [InlineData("vp", "VP")]
    [InlineData("_RPA", "RP")]
    [InlineData("PR 100,200", "PR")]
    [InlineData("BGS", "BG")]
    [InlineData("ENDIF", "ENDIF")]
    [InlineData("TIME", "TIME")]
    public void A_command_is_found_as_it_is_written(string words, string command)
    {
        Assert.True(CommandHelpTable.TryFind(words, out var help));
        Assert.Equal(command, help.Command);
    }

    [Theory]
    [InlineData("")]
    [InlineData("LD")]
    [InlineData("?")]
    public void What_the_controller_does_not_have_is_not_found(string words) => Assert.False(CommandHelpTable.TryFind(words, out _));
}
