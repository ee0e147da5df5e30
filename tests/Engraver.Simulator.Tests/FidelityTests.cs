using System.Text.RegularExpressions;
using Engraver.Simulator.Language;
using Engraver.Simulator.Language.Commands;

namespace Engraver.Simulator.Tests;

/// <summary>docs/simulator-fidelity.md agrees with the dispatch table.</summary>
public class FidelityTests
{
    /// <summary>galil-dmc.md 0.4, first row, without TIME, which is an operand.</summary>
    private const string CommandsOfTheDmc21X3 =
        "AB AC AD AF AG AI AL AM AO AP AQ AR AS AT AU AV BA BC BD BG BI BK BL BM BN BP BR BV BZ CA CB CD CE CF CI CM CN CR CS CW DA DC DE DL DM DP DR DT DV "
        + "EA EB EC ED EG ELSE EM EN ENDIF EO EP EQ ER ES ET EW FA FE FI FL FV GA GD GM GR HM HS HX IA IF IH II IK IL IP IT JG JP JS KD KI KP KS LA LC LE LI "
        + "LL LM LS LV LZ MB MC MF MG MO MR MT MW NB NF NO NZ OB OC OE OF OP PA PF PL PT PR QD QH QR QS QU QZ RA RC RD RE RI RL RP RS SB SC SH SL SP ST TA TB "
        + "TC TD TE TH TI TK TL TM TN TP TR TS TT TV TW TZ UL VA VD VE VF VM VP VR VS WH WT XQ YA YB YC YR YS ZS";

    private static readonly string[] RequiredOperands =
    [
        "RP", "TP", "BG", "LM", "CS", "AV", "VS", "VA", "VD", "VR", "VM", "VP", "MO", "SC", "TC", "XQ", "HX", "NO", "TM", "OP", "EO", "CF", "CW", "DR",
        "DL", "UL", "DM", "DA", "IA", "BN", "BV", "ED", "QZ", "VE", "LE", "TN", "CA", "TD", "TE", "LF", "LR", "HM", "ZS", "AB", "CN", "WH", "IH", "LZ", "PF",
        "VF", "TI", "JS", "TS", "CM", "DT", "EB", "EC", "EG", "EM", "EP", "EQ", "RC", "RD",
    ];

    [Fact]
    public void Every_command_is_either_implemented_or_listed_as_missing_and_never_both()
    {
        var page = File.ReadAllText(Path.Combine(Root(), "docs", "simulator-fidelity.md"));
        var list = Regex.Match(page, "```\n(.*?)```", RegexOptions.Singleline).Groups[1].Value;
        var missing = list.Split([' ', '\n'], StringSplitOptions.RemoveEmptyEntries);
        var all = CommandsOfTheDmc21X3.Split(' ');

        Assert.Equal(all.Except(CommandTable.Mnemonics).Order(), missing.Order());
        Assert.Equal(missing.Order(), CommandTable.NotModelled.Order());
        Assert.Empty(CommandTable.Mnemonics.Where(m => m[0] >= 'A').Except(all).Except(["VT", "WC"]));
    }

    [Fact]
    public async Task A_missing_command_is_refused_with_code_1()
    {
        await using var rig = new SimulatorRig();

        Assert.All(new[] { "OCA=1", "GDA=0", "EW 1=5", "LD ?", "CO 1", "EO 0" }, c => Assert.Equal(1, rig.Refusal(c)));
    }

    [Fact]
    public void Operands_of_the_reference_exist() => Assert.Empty(RequiredOperands.Except(Operands.Names));

    [Theory]
    [InlineData("_LM", 511)]
    [InlineData("_VSS", 25000)]
    [InlineData("_VAT", 256000)]
    [InlineData("_VRS", 1)]
    [InlineData("_SPA", 25000)]
    [InlineData("_ACD", 256000)]
    [InlineData("_MOA", 0)]
    [InlineData("_MTA", 1)]
    [InlineData("_XQ0", -1)]
    [InlineData("_HX7", 0)]
    [InlineData("_NO", 0)]
    [InlineData("_TM", 1000)]
    [InlineData("_CF", 83)]
    [InlineData("_CW", 2)]
    [InlineData("_CW4", 1)]
    [InlineData("_DR0", 0)]
    [InlineData("_DL", 254)]
    [InlineData("_UL", 254)]
    [InlineData("_DM", 8000)]
    [InlineData("_DA", 30)]
    [InlineData("_IA2", 7)]
    [InlineData("_IA3", 0)]
    [InlineData("_IHA2", 2)]
    [InlineData("_IHB2", 0)]
    [InlineData("_BV", 4)]
    [InlineData("_ED", 0)]
    [InlineData("_ED1", -1)]
    [InlineData("_QZ0", 4)]
    [InlineData("_QZ3", 28)]
    [InlineData("_LFA", 1)]
    [InlineData("_AB", 1)]
    [InlineData("_CN0", -1)]
    [InlineData("_FLA", 2147483647)]
    [InlineData("_BLA", -2147483648)]
    [InlineData("_KPA", 6)]
    public async Task Operands_have_their_power_up_values(string operand, double value)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(value, rig.Value(operand));
    }

    private static string Root()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (!File.Exists(Path.Combine(folder.FullName, "CncEngraver.sln")))
        {
            folder = folder.Parent ?? throw new DirectoryNotFoundException("The solution's folder is above the tests.");
        }

        return folder.FullName;
    }
}
