using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>Each unit changes in one place: drawing units and millimetres in DrawingScale, millimetres and counts in CountsScale (with AxisScale); the names
/// of the axes are those of MachineAxes. The simulator shares no code with the product and is not searched. units.txt lists the exceptions.</summary>
public partial class UnitConversionTests
{
    private const string ListName = "tests/Engraver.Architecture.Tests/Structure/units.txt";

    private static readonly string[] s_homes = ["src/Engraver.Core/Machines/AxisScale.cs", "src/Engraver.Core/Machines/CountsScale.cs", "src/Engraver.Core/Drawings/DrawingScale.cs"];

    private static readonly Lazy<IReadOnlyList<Finding>> s_found = new(() => [.. Product().SelectMany(Find)]);

    [Fact]
    public void No_unit_is_converted_outside_of_its_home()
    {
        var found = s_found.Value.Where(one => one.Rule == Rule.Arithmetic).ToList();
        Assert.True(found.Count == 0, $"Convert with a method of DrawingScale, CountsScale or AxisScale:\n{string.Join('\n', found)}");
    }

    [Fact]
    public void Factors_inches_and_axis_names_are_read_only_where_the_list_gives_a_reason()
    {
        var allowed = Listed();
        var found = s_found.Value.Where(one => one.Rule != Rule.Arithmetic && !allowed.Contains((one.Rule, one.File))).ToList();
        Assert.True(found.Count == 0, $"Use DrawingScale, CountsScale, LengthUnits or MachineAxes.Names. A number that is only shown or stored is listed with its reason in {ListName}:\n{string.Join('\n', found)}");
    }

    [Fact]
    public void The_list_has_no_entry_without_a_use()
    {
        var gone = Listed().Except(s_found.Value.Select(one => (one.Rule, one.File))).ToList();
        Assert.True(gone.Count == 0, $"Remove these from {ListName}:\n{string.Join('\n', gone)}");
    }

    [Theory]
    [InlineData("var counts = axis.CountsPerMillimetre * length;", Rule.Arithmetic)]
    [InlineData("var counts = length * Math.Abs(axis.CountsPerMillimetre);", Rule.Arithmetic)]
    [InlineData("var place = counts / machine.Scale.X.CountsPerMillimetre;", Rule.Arithmetic)]
    [InlineData("var place = (a + b) / (unit.MillimetresPerUnit);", Rule.Arithmetic)]
    [InlineData("double Of(double countsPerMillimetre) => 60.0 * countsPerMillimetre;", Rule.Arithmetic)]
    [InlineData("var factor = drawing.Unit.MillimetresPerUnit;", Rule.Factor)]
    [InlineData("var factor = axes.Z?.CountsPerMillimetre;", Rule.Factor)]
    [InlineData("var inches = length / 25.4;", Rule.Inch)]
    [InlineData("foreach (var (name, axis) in \"XYZ\".Zip(axes)) Show(name);", Rule.AxisNames)]
    public void A_conversion_is_noticed(string code, Rule rule) => Assert.Contains(Find(new SourceFile("src/P/One.cs", code)), found => found.Rule == rule);

    [Theory]
    [InlineData("var counts = axis.Scale.Exact(length);")]
    [InlineData("/// <summary>An inch has 25.4 mm; counts * CountsPerMillimetre; \"XYZ\".</summary>")]
    [InlineData("var axis = other with { CountsPerMillimetre = 1000.0 };")]
    [InlineData("var feed = profile.FeedMmPerMinute / 60.0;")]
    [InlineData("var x = 125.4 + 25.45;")]
    public void Other_code_is_not_a_conversion(string code) => Assert.Empty(Find(new SourceFile("src/P/One.cs", code)));

    private static IEnumerable<SourceFile> Product() => new[] { "src", "tools", "benchmarks" }
        .SelectMany(folder => SourceFile.Under(folder, ".cs"))
        .Where(file => !file.Name.StartsWith("src/Engraver.Simulator/", StringComparison.Ordinal) && !s_homes.Contains(file.Name));

    private static IEnumerable<Finding> Find(SourceFile file)
    {
        var parsed = CSharpText.Parse(file.Text);
        foreach (Match found in Arithmetic().Matches(parsed.Code)) yield return At(Rule.Arithmetic, found);
        foreach (Match found in Factor().Matches(parsed.Code)) yield return At(Rule.Factor, found);
        foreach (Match found in Inch().Matches(parsed.Code)) yield return At(Rule.Inch, found);
        foreach (Match found in AxisNames().Matches(file.Text))
        {
            if (parsed.Comments[found.Index] == ' ') yield return At(Rule.AxisNames, found);
        }

        Finding At(Rule rule, Match found) => new(rule, file.Name, file.LineOf(found.Index), found.Value);
    }

    private static HashSet<(Rule Rule, string File)> Listed() =>
        [.. File.ReadAllLines(Path.Combine(RepositoryFolder.Root, ListName)).Where(line => line.Length > 0 && line[0] != '#').Select(Entry)];

    /// <summary>A line: rule, file, reason.</summary>
    private static (Rule Rule, string File) Entry(string line)
    {
        var parts = line.Split('|', StringSplitOptions.TrimEntries);
        Assert.True(parts is [_, _, { Length: > 0 }], $"{ListName} needs \"rule | file | reason\": {line}");
        return (Enum.Parse<Rule>(parts[0]), parts[1]);
    }

    [GeneratedRegex(@"[*/]\s*\(*(Math\.Abs\(|[\w!?]+\.)*(countsPerMillimetre|millimetresPerUnit)\b|\b(countsPerMillimetre|millimetresPerUnit)\s*\)*\s*[*/]", RegexOptions.IgnoreCase)]
    private static partial Regex Arithmetic();

    /// <summary>A member that is a number; the fields of documents of files that have the same name are records, read with <c>?.</c>.</summary>
    [GeneratedRegex(@"\.(CountsPerMillimetre|MillimetresPerUnit)\b(?!\?\.)")]
    private static partial Regex Factor();

    [GeneratedRegex(@"(?<![\d.])25\.4(?!\d)")]
    private static partial Regex Inch();

    [GeneratedRegex("\"XYZ\"")]
    private static partial Regex AxisNames();

    public enum Rule
    {
        Arithmetic,
        Factor,
        Inch,
        AxisNames,
    }

    private sealed record Finding(Rule Rule, string File, int Line, string Text)
    {
        public override string ToString() => $"{File}({Line}): {Text} ({Rule})";
    }
}
