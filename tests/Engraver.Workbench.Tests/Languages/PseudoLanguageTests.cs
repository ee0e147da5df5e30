using System.Globalization;
using Engraver.Core.Languages;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Languages;

/// <summary>Runs every command in the pseudo-language. An unmarked letter is text that cannot be translated.</summary>
public class PseudoLanguageTests
{
    /// <summary>Words that are equal in every language: echoed input and text from a machine.</summary>
    private static readonly string[] s_stays = ["mm", "s", "in", "x", "TC"];

    /// <summary>Commands that write a file in a machine language; Enter alone would show it.</summary>
    private static readonly string[] s_machineText = ["POST", "PLOT", "TABLE"];

    /// <summary>Inputs in addition to "every default" and "nonsense", which each command gets.</summary>
    private static readonly string[][] s_talks =
    [
        ["LINE?", "'PAN", "MOVE", "'MOVE", "'ZOOM", "E", "ALL", "", "0,0", "5,5"],
        ["MOVE", "W", "0,0", "@1,1", "R", "5,0", "", "", "SELECT", "5,0", "5,0", "LA", "0", "H", "A1", "H", "ZZ", "U", ""],
        ["COPY", "ALL", "", "D", "3,4", "U", "U", "UNDO", "99", "REDO", "REDO"],
        ["ARRAY", "5,0", "", "R", "2", "2", "5", "5", "ARRAY", "5,0", "", "PO", "0,0", "3", "360", "ARRAY", "5,0", "", "R", "9999", "9999"],
        ["ROTATE", "ALL", "", "0,0", "R", "10", "20", "SCALE", "ALL", "", "0,0", "R", "1", "2", "SCALE", "ALL", "", "0,0", "0"],
        ["MIRROR", "ALL", "", "0,0", "0,0", "MIRROR", "ALL", "", "0,0", "0,1", "Y"],
        ["EXPLODE", "ALL", "", "JOIN", "ALL", "", "JOIN", "A3", "OVERKILL", "", "ORIGIN", "C", "HIDEOBJECTS", "5,0", "", "UNISOLATEOBJECTS", "EXPLODE", "5,0", ""],
        ["POCKET", "20,5", "", "1", "0.6", "Z", "30", "2", "1", "POCKET", "20,5", "", "", "", "C", "0", "POCKET", "20,5", "", "50", "", "", "", "POCKET", "5,0", "", "1", "", "C", "0"],
        ["LAYER", "?", "C", "red", "*", "OFF", "*", "", "LAYER", "F", "nowhere", "*", "C", "mauve", "red", "*", "M", "a|b", "a", "S", "nowhere", "a", "R", "0", "a", "0", "b", "", "CHECK", "CNCARM"],
        ["AREA", "0,0", "10,0", "10,10", "", "AREA", "O", "20,5", "", "AREA", "O", "5,0", "DIST", "0,0", "3,4", "ID", "1,2", "LIST", "ALL", "", "PROPERTIES"],
        ["ENTER", "H", "ZZ", "ENTER", "H", "A1", "ERASE", "H", "A1", "", "ENTER", "P", "1,1", "ENTER", "N", "TOOLSTART", "1,1"],
        ["OFFSET", "2", "5,0", "3,7", "99,99", "U", "U", "", "OFFSET", "E", "Y", "L", "nowhere", "OFFSET", "3", "20,8", "20,5", "", "OFFSET", "T", "5,0", "", "KERF", "N", "4", "CHECK", "CNCARM", "KERF", "OFF"],
        ["SEQUENCE", "AUTOSEQUENCE", "DISCONTINUITIES", "CNCORDER", "D", "CHECK", "OPTIONS", "CNCFEED", "1e99", "CNCFEED", "1e9", "500", "OPTIONS", "nothing"],
        ["CNCCONNECT", "nowhere", "CNCCONNECT", "sim:", "CNCSTATUS", "CNCMOTORS", "OFF", "CNCARM", "", "CNCMOTORS", "ON", "CNCARM", "", "CNCSTATUS", "CNCRUN", "Yes", "CNCSTATUS", "CNCTERMINAL", "help", "CNCTERMINAL", "XX", "CNCTERMINAL", "RS", "CNCGOTO", "1,1", "CNCGOTO", "S", "CNCGOTO", "1e99,0", "ALARMS", "ALARMS", "A", "ALARMS", "H", "ALARMS", "7", "CNCHOLD", "CNCRESUME", "CNCOVERRIDE", "5000", "90", "CNCOVERRIDE", "Rapid", "50", "CNCSTOP", "CNCABORT", "ALARMS", "CNCDISCONNECT", "CNCDISCONNECT"],
        ["CNCCONNECT", "sim:", "CNCCOMMISSION", "", "Low", "", "Y", "", "", "", "P", "R", "", "", "", "A", "High", "N", "High", "Y", "", "1e9", "N", "500", "Y", "", "", "", "Y", "N", "Back", "", "", "", "Y", "Y", "Right", "Y", "Y", "Nothing", "", "", "", "Y", "5", "Y", "", "N", "", "", "Y", "Right", "Left", "B", "", "", "Y", "B", "R", "9", "1", "Y", "Y", "Y", "none/a.json", "a.json", "Y"],
        ["CNCCONNECT", "sim:", "CNCTERMINAL", "MOA", "CNCCOMMISSION", "End", "No", "CNCCOMMISSION", "S", "S", "S", "S", "", "", "", "N", "B", "", "", "", "Y", "Y", "Wild", "E", "Y", "a.json"],
        ["CNCCONNECT", "tcp://127.0.0.1:1", "CNCCONNECT", "serial:///dev/null/none", "CNCSTATUS"],
        ["CNCSIM", "PLAYBACK", "T", "1", "PLAYBACK", "R", "1", "PLAYBACK", "R", "999", "PLAYBACK", "PA", "PLAYBACK", "C", "1", "PLAYBACK", "L", "1", "PLAYBACK", "?", "SHOW", "?", "SHOW", "R", "OFF", "THEME", ""],
        ["POST", "Galil", "a.dmc", "VERIFY", "a.dmc", "MOVE", "5,0", "", "0,0", "1,1", "VERIFY", "a.dmc", "POST", "Galil", "a.dmc", "N", "PLOT", "P", "a.svg", "EXPORT", "a.svg", "N", "EXPORT", "a.txt", "EXPORT", "b.csv", "TABLE", "S", "C", "a.csv", "POST", "Galil", "no/folder/a.dmc"],
        ["SAVEAS", "a.dxf", "OPEN", "a.dxf", "OPEN", "none.dxf", "OPEN", ".", "CLOSE", "MOVE", "CHECK", "RECENT", "RECENT", "1", "SCRIPT", "none.scr", "REINIT", "HELP", "", "HELP", "MOVE", "HELP", "nothing", "ZOOM", "P", "ZOOM", "W", "0,0", "0,0", "ZOOM", "C", "0,0", "", "ZOOM", "S", "0X", "ZOOM", "5"],
        ["SACEPATH", "ALL", "", "SACESHOWTRAJECTORIES", "SACETOGGLEDYNAMICDENSITY", "SACESETSTATICSEGMENTLENGTH", "9", "SACEPATH", "H", "A3", "", "SACEOFFSET", "H", "A3", "", "50", "In", "SACEOFFSET", "H", "A1", "", "1", "0,1", "SACEUNIFORMOFFSET", "H", "A3", "", "1", "1", "2", "Out", "SACECONSTANTOFFSETS", "H", "A3", "", "2", "1", "1"],
        ["SACEHELICALDRILL", "0,0", "1", "2", "SACEHELICALDRILL", "0,0", "2", "1", "1", "0.5", "C", "SACEEXPORTTRAJECTORIES", "L", "out", "SACEDEEPENGRAVING", "H", "A3", "", "0.001", "99", "SACEEDITTRAJECTORY", "none", "SACEEDITTRAJECTORY", "traj0_drill", "Up", "SACEEDITTRAJECTORY", "traj0_drill", "Error", "1", "SACEEDITTRAJECTORY", "traj0_drill", "Name", "../x", "SACESETMAXERROR", "0", "1", "SACECORNERS", "", "SACEEXPORTTRAJECTORIES", "S", "out", "SACEEXPORTTRAJECTORIES", "S", "out", "N", "SACEDELETELASTTRAJECTORY", "SACEDELETEALLTRAJECTORIES"],
        ["SAVEAS", "a.dxf", "OPEN", "a.dxf", "QSAVE", "SACEPATH", "L", "", "QSAVE", "MOVE", "L", "", "0,0", "1,1", "QSAVE", "N", "QSAVE", "Y", "OPEN", "a.dxf"],
        ["OSNAP", "END,MID", "OSNAP", "XYZ", "GRID", "5", "SNAP", "ON", "ORTHO", "ON", "DYNAMICINPUT", "OFF", "CURSORSIZE", "500", "CURSORSIZE", "1.5", "CURSORSIZE", "50", "CNCPROFILE", "none.json", "REGEN", "PAN", "0,0", "1,1"],
    ];

    public static TheoryData<string> Commands => [.. CommandCatalog.Built().All.Select(info => info.Name)];

    public static TheoryData<int> Talks => [.. Enumerable.Range(0, s_talks.Length)];

    [Theory]
    [MemberData(nameof(Commands))]
    public async Task Every_command_speaks_the_language_with_defaults_and_with_nonsense(string command)
    {
        string[] defaults = s_machineText.Contains(command) ? [command] : [command, "", "", "", "", ""];
        await AssertSpokenAsync(defaults);
        await AssertSpokenAsync([command, "?", "%", "0", "-1", "1e99,1e99"]);
        await AssertSpokenAsync(["HELP", command, "'" + command]);
    }

    [Theory]
    [MemberData(nameof(Talks))]
    public Task Every_conversation_is_in_the_language(int talk) => AssertSpokenAsync(s_talks[talk]);

    [Fact]
    public void Every_setting_is_described_in_the_language()
    {
        CultureInfo.CurrentUICulture = new CultureInfo(PseudoLanguage.CultureName);
        try
        {
            Assert.All(SettingTable.All, setting => Assert.Empty(PseudoLanguage.UnmarkedWords(setting.Name + SettingWording.OnConsole(setting.Meaning) + SettingWording.AtCommandLine(setting.Meaning))));
        }
        finally
        {
            CultureInfo.CurrentUICulture = CultureInfo.InvariantCulture;
        }
    }

    private static async Task AssertSpokenAsync(string[] inputs)
    {
        CultureInfo.CurrentUICulture = new CultureInfo(PseudoLanguage.CultureName); // flows with this task alone
        await using var talk = CommandTestSession.WithDrawing();
        var shown = new List<string>();
        foreach (var input in inputs)
        {
            shown.Add(talk.Session.Prompt.Text);
            await talk.TypeAsync(input);
        }

        await talk.Session.CancelAsync();
        shown.AddRange(talk.Said.Split('\n'));
        var wrong = shown.Where(line => PseudoLanguage.UnmarkedWords(line).Except(s_stays).Any() || HiddenSentence.IsIn(line)).Distinct().ToList();
        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
        Assert.Contains(shown, line => line.Contains('⟦', StringComparison.Ordinal));
    }
}
