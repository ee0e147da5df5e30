using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Workbench.Tests.CommandLanguage;

public class ScriptTextTests
{
    [Theory]
    [InlineData("OPEN a.dxf\nCHECK\n", "1:OPEN|1:a.dxf|2:CHECK")]
    [InlineData("MOVE ALL\n\n0,0\n", "1:MOVE|1:ALL|2:|3:0,0")]
    [InlineData("ERASE ALL \nU", "1:ERASE|1:ALL|1:|2:U")]
    [InlineData("; a comment\nU\r\n;U\r\n", "2:U")]
    [InlineData("OPEN \"my drawing.dxf\"", "1:OPEN|1:my drawing.dxf")]
    [InlineData("", "")]
    public void Spaces_and_line_ends_are_Enter(string script, string inputs) =>
        Assert.Equal(inputs, string.Join('|', ScriptText.Read(script).Select(token => FormattableString.Invariant($"{token.Line}:{token.Text}"))));

    [Property]
    public Property What_is_written_is_read_back() =>
        Prop.ForAll(Gen.Elements("OPEN", "", "my file.dxf", ";x", "@3,4", "'ID", "5<90").ToArrays(), typed =>
        {
            var script = string.Concat(typed.Select(input => ScriptText.Write(input) + "\n"));
            return ScriptText.Read(script).Select(token => token.Text).SequenceEqual(typed);
        });
}
