using Engraver.Core.EntityTables;
using Engraver.Core.Sequencing;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Lines without a part to cut.</summary>
public class FlatLineTests
{
    [Theory]
    [InlineData(0.0, "has no length: it has fewer than two different points.")]
    [InlineData(5.0, "has no length: it is vertical, a point in plan view.")]
    public void A_line_that_is_a_spot_from_above_is_one_finding_and_no_row_of_the_table(double height, string words)
    {
        var drawing = DxfReading.Entities((0, "LINE"), (10, 1), (20, 2), (30, 0), (11, 1), (21, 2), (31, height), (0, "LINE"), (10, 0), (20, 0), (11, 3), (21, 4));
        var table = EntityTableBuilder.Build(drawing, LayerSelection.Default);
        var sequence = Sequencer.Sequence(ArcAnalysis.Analyse(table), drawing, UsualOptions.Sequencing);

        Assert.Equal((2, 1, 5.0), (drawing.Entities.Count, table.Count, sequence.PathLength));
        Assert.Contains(words, Assert.Single(drawing.Diagnostics).Message, StringComparison.Ordinal);
        Assert.DoesNotContain(sequence.Diagnostics, found => found.Id == "SEQ0004");
    }
}
