using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>The machine seam (ADR 9): DMC text is in Engraver.Galil only; the driver, the links and the simulator are named in Workbench/Composition
/// only. Exceptions are listed in seam.txt, which may only become shorter.</summary>
public partial class MachineSeamTests
{
    private const string ListName = "tests/Engraver.Architecture.Tests/Structure/seam.txt";

    private static readonly Lazy<IReadOnlyList<SourceFile>> s_above = new(() => [.. new[] { "src/Engraver.Workbench", "src/Engraver.Cli", "src/Engraver.App" }.SelectMany(folder => SourceFile.Under(folder, ".cs"))]);

    [Fact]
    public void Nobody_new_meets_the_driver_outside_of_composition()
    {
        var fresh = Meeting().Except(Listed()).ToList();
        Assert.True(fresh.Count == 0, $"These name Engraver.Galil, Engraver.Links or Engraver.Simulator, and are not in {ListName}. Talk to Core/Machines, or put what composes into src/Engraver.Workbench/Composition:\n{string.Join('\n', fresh)}");
    }

    [Fact]
    public void Who_no_longer_meets_the_driver_leaves_the_list()
    {
        var gone = Listed().Except(Meeting()).ToList();
        Assert.True(gone.Count == 0, $"Take these out of {ListName}:\n{string.Join('\n', gone)}");
    }

    [Fact]
    public void No_command_of_the_controller_stands_outside_of_its_driver()
    {
        var found = s_above.Value.SelectMany(Commands).ToList();
        Assert.True(found.Count == 0, $"DMC belongs into src/Engraver.Galil:\n{string.Join('\n', found)}");
    }

    [Theory]
    [InlineData("""channel.SendAsync("XQ#JOB")""")]
    [InlineData("""$"CB {output}" """)]
    [InlineData("""send("STS")""")]
    [InlineData("""on ? "SHAB" : "MOAB" """)]
    [InlineData("""ReadAsync("_RPA,_RPB")""")]
    [InlineData("""line.StartsWith("VP ")""")]
    [InlineData("""a + ";ST " + letters""")]
    public void A_command_is_noticed(string code) => Assert.NotEmpty(Commands(new SourceFile("src/P/One.cs", code)));

    [Theory]
    [InlineData("""Say("STOP")""")]
    [InlineData("""Say("Stopped by the operator.")""")]
    [InlineData("""// "CB 1" switches the tool off""")]
    [InlineData("""Key("CNCCONNECT", "MOVE", "ABOUT")""")]
    public void A_word_for_people_is_no_command(string code) => Assert.Empty(Commands(new SourceFile("src/P/One.cs", code)));

    private static IEnumerable<string> Meeting() => s_above.Value
        .Where(file => !file.Name.StartsWith("src/Engraver.Workbench/Composition/", StringComparison.Ordinal) && Driver().IsMatch(CSharpText.Parse(file.Text).Code))
        .Select(file => file.Name);

    private static IEnumerable<string> Commands(SourceFile file)
    {
        var parsed = CSharpText.Parse(file.Text);
        var texts = string.Concat(file.Text.Select((c, i) => char.IsWhiteSpace(c) || (parsed.Code[i] == ' ' && parsed.Comments[i] == ' ') ? c : '\u0001'));
        return Command().Matches(texts).Select(found => $"{file.Name}({file.LineOf(found.Index)}): {found.Value}");
    }

    private static List<string> Listed() => [.. File.ReadAllLines(Path.Combine(RepositoryFolder.Root, ListName)).Where(line => line.Length > 0 && line[0] != '#')];

    [GeneratedRegex(@"\bEngraver\.(Galil|Links|Simulator)\b")]
    private static partial Regex Driver();

    /// <summary>At the start of a text or after a semicolon: a command with its axes and then a number, a hole, another command or the end; or an
    /// operand.</summary>
    [GeneratedRegex(@"[""';](SH|MO|ST|AB|CB|SB|HX|BG|AM|VM|VP|CR|VE|VS|VA|VD|SP|PA|PR|AC|DC|DP|LI|LM|CS|XQ|MG|TC|JG|WT|DL|UL|QR|RS|BN|BP|BV|EO|CF|CW|VF)[A-HS]{0,8}([ =#]?(-?[0-9]|\{|_|#|[A-H]+\b)|[ =]?["";])|""_[A-Z]{2}[A-HS0-9]?\b")]
    private static partial Regex Command();
}
