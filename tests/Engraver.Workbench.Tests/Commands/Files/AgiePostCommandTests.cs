using System.Text.RegularExpressions;
using Engraver.TestKit;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands.Files;

public class AgiePostCommandTests
{
    [Fact]
    public async Task The_sequenced_drawing_is_written_foretold_and_verified_in_a_row()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "AUTOSEQUENCE", "AGIEPOST", "Exact", "gasket.agie", "VERIFY", "");

        Assert.StartsWith("%\t001\t", await File.ReadAllTextAsync(talk.PathOf("gasket.agie")), StringComparison.Ordinal);
        Assert.Contains("maximum deviation from the path: 0.000", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Without_a_file_name_the_blocks_stand_in_the_command_window_and_the_style_is_remembered()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Arc(0, 0, 10, 0.4, 90.4).Build() });
        await talk.TypeAsync("AGIEPOST", "Paper", "", "AGIEPOST", "", "");

        Assert.Equal(2, Regex.Count(talk.Said, "\t001\t0[23]\t0[09]0\t090\t"));
    }
}
