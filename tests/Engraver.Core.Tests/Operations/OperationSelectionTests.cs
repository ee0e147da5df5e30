using Engraver.Core.Drawings;
using Engraver.Core.Tests.Dxf;
using static Engraver.TestKit.LinetypeDrawing;

namespace Engraver.Core.Tests.Operations;

public class OperationSelectionTests
{
    /// <summary>Lines on HIDDEN (DASHED by layer) and of linetype DOT, a BRACKET with a HOLE in it, and a HOLE.</summary>
    private static Drawing Drawn => DxfReading.Of(Of([.. Line("HIDDEN", 0, 0, 9, 0), .. Line("0", 0, 1, 9, 1, (6, "DOT")), .. Insert("BRACKET", 100, 50), .. Insert("HOLE", 200, 0)]));

    [Theory]
    [InlineData("""{"linetypes": ["dashed"]}""", "0 3")]
    [InlineData("""{"linetypes": ["DOT"]}""", "1 2")]
    [InlineData("""{"linetypes": ["Continuous"]}""", "4 5 6")]
    [InlineData("""{"blocks": ["bracket"]}""", "2 3 4")]
    [InlineData("""{"blocks": ["HOLE"]}""", "3 4 5 6")]
    [InlineData("""{"blocks": ["HOLE"], "linetypes": ["DOT"]}""", "1 2 3 4 5 6")]
    public void Effective_linetypes_and_blocks_at_any_depth_are_taken(string select, string expected)
    {
        var job = new OperationJob(Drawn, $$"""{ "id": "a", "kind": "engrave", "select": {{select}}, "tool": 1, "depth": 1 }""");

        Assert.Empty(job.Assignment.Faults);
        Assert.Equal(expected, string.Join(' ', Enumerable.Range(0, job.Assignment.Parts[0].Table.Count).Select(job.Assignment.Parts[0].Table.EntityIndexOf).Distinct()));
    }

    [Theory]
    [InlineData("""{"linetypes": ["DASHD"]}""", "OPR0040", "DASHED")]
    [InlineData("""{"linetypes": ["BYLAYER"]}""", "OPR0040", "")]
    [InlineData("""{"blocks": ["BRACKETS"]}""", "OPR0041", "BRACKET")]
    public void Unknown_names_are_faults_with_the_nearest(string select, string id, string nearest)
    {
        var fault = Assert.Single(new OperationJob(Drawn, $$"""{ "id": "a", "kind": "engrave", "select": {{select}}, "tool": 1, "depth": 1 }""").Assignment.Faults);

        Assert.Equal(id, fault.Id);
        Assert.Contains(nearest, fault.Facts[2], StringComparison.Ordinal);
    }
}
